#include "apps/view_model/key_bindings.h"

namespace manylight {

const std::vector<KeyBinding>& keyBindings() {
    static const std::vector<KeyBinding> bindings = {
        {"w", "", "forward"},
        {"s", "", "back"},
        {"a", "", "left"},
        {"d", "", "right"},
        {"e", "", "up"},
        {"q", "", "down"},
        {"shift", "", "faster"},
        {"o", "next navigation", "fly, or orbit about what is looked at"},
        {"r", "reset-view", "back to the scene's camera"},
        {"tab", "next panel", "panels on and off"},
        {"f1", "next keys", "this list"},
        {"f2", "next timings", "times"},
        {"t", "next technique", "next technique"},
        {"l", "next lighting", "local, global, both kinds of light"},
        {"v", "next show", "next view: VPLs, G-buffer channels, what the bound takes, rays"},
        {"h", "next shadows", "shadows"},
        {"c", "next clamp", "next clamp mode"},
        {"m", "next tone-map", "next tone curve"},
        {"p", "next play", "play the animation, or pause it"},
        {"z", "undo", "take back the last change of lights"},
        {"x", "next compare", "split screen, difference, neither"},
        {"f5", "restart", "forget the frames so far"},
        {"f6", "copy-view", "copy the view"},
        {"f7", "save-view", "save the view as a sidecar"},
        {"f8", "capture", "save the picture"},
        {"f9", "screenshot", "save the window"},
        {"escape", "quit", "quit"},
    };
    return bindings;
}

std::string commandOfKey(const std::string& key) {
    for (const KeyBinding& binding : keyBindings())
        if (key == binding.key) return binding.command;
    return {};
}

}  // namespace manylight
