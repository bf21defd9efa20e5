// What commands do.
#include "apps/view/viewer.h"

#include "apps/view_model/key_bindings.h"

#include <algorithm>

namespace manylight {
namespace {

const char* const kOtherPrefix = "other.";

const SettingHelp* helpOf(const std::string& option) {
    for (const auto* helps : {&viewSettingHelps(), &settingHelps()})
        for (const SettingHelp& help : *helps)
            if (option == help.option) return &help;
    return nullptr;
}

}  // namespace

void Viewer::perform(const Command& command) {
    try {
        performCommand(command);
    } catch (const Error& error) {
        tell(error.what(), true);
    }
}

void Viewer::performCommand(const Command& command) {
    const std::string& name = command.name();
    const std::vector<std::string>& words = command.words;
    if (name == "set") return set(words[1], words[2]);
    if (name == "next") return chooseNext(words[1]);
    if (name == "camera") return set("camera", words[1]);
    if (name == "reset-view") return set("camera", std::to_string(main_.settings.camera));
    if (name == "restart") {
        main_.forget();
        return other_.forget();
    }
    if (name == "fps-table") return startFps(command);
    if (name == "watch") {
        if (reloader_) watchesToGo_ = reloader_->isRunning() ? 2 : 1;  // what runs may have looked too early
        return;
    }
    if (name == "wait-for") {
        awaited_ = words[1];
        return;
    }
    if (name == "quit") return window_.close();
    if (name == "frames") {
        if (state_.view.plays)
            fail("{}: frames: expected 'set play off' before; what plays has no mean", command.place);
        if (window_.isMinimised()) fail("{}: frames: expected 'restore' before", command.place);
        holdFrames_ = command.whole(1, 1, 1 << 24);
        for (Side* side : {&main_, &other_})
            if (side->frameCount() > holdFrames_) side->forget();
        return;
    }
    if (performFileCommand(command) || performLightCommand(command) || performWindowCommand(command)) return;
    pretendInput(command);
}

void Viewer::pretendInput(const Command& command) {
    const std::string& name = command.name();
    const std::vector<std::string>& words = command.words;
    holdFrames_ = 0;  // the picture may go on
    const auto framesAt = [&](size_t index) { return index < words.size() ? command.whole(index, 1, 1 << 20) : 1u; };
    if (name == "key") {
        input_.pretendKey(words[1], framesAt(2));
        waitFrames_ = framesAt(2);
    } else if (name == "drag") {
        if (words[1] != "left" && words[1] != "right") fail("{}: drag: expected left or right", command.place);
        input_.pretendDrag(words[1] == "right", {command.number(2), command.number(3)}, framesAt(4));
        waitFrames_ = framesAt(4);
    } else if (name == "wheel") {
        input_.pretendWheel(command.number(1));
    } else {
        waitFrames_ = command.whole(1, 1, 1 << 20);
    }
}

void Viewer::stopFps() {
    if (!fps_.isRunning()) return;
    fps_.stop();
    main_.forget();  // its renderer is as the measurement left it
}

void Viewer::startFps(const Command& command) {
    const bool closes = command.words.size() == 2 && command.words[1] == "off";
    if (closes) {
        stopFps();
        fps_ = {};
        return;
    }
    if (fps_.isRunning()) return stopFps();
    if (!main_.exists()) fail("{}: there is no picture to measure", command.place);
    state_.latency.stop();
    std::vector<uint32_t> vplCounts;
    for (size_t i = 1; i < command.words.size(); ++i) vplCounts.push_back(command.whole(i, 1, 1 << 21));
    RenderSettings settings = main_.settings;
    settings.width = sideView().size.x;
    settings.height = sideView().size.y;
    fps_.start(settings, std::move(vplCounts), device_.info().isSoftware());
    state_.view.plays = false;
}

void Viewer::set(const std::string& option, const std::string& value) {
    if (isPlaybackSetting(option) && !playable_.isAnimated()) fail("{}: nothing moves in this scene", option);
    if (isViewSetting(option)) return applyViewSetting(state_.view, option, value);
    if (option.starts_with(kOtherPrefix)) return applySetting(other_.settings, option.substr(6), value);
    applySetting(main_.settings, option, value);
    if (option == "size") window_.resize({main_.settings.width, main_.settings.height});
    if (option != "camera") return;
    const size_t count = state_.scene->cameras.size();
    if (main_.settings.camera >= count) {
        main_.settings.camera = other_.settings.camera;
        fail("camera {}: the scene has {}, counted from 0", value, count);
    }
    other_.settings.camera = main_.settings.camera;
    state_.cameraMoved = false;
    state_.motion.look(poseOf(state_.scene->cameras[main_.settings.camera], state_.scene->frame));
}

void Viewer::chooseNext(const std::string& option) {
    const bool isOther = option.starts_with(kOtherPrefix);
    const std::string plain = isOther ? option.substr(6) : option;
    const SettingHelp* help = helpOf(plain);
    if (help == nullptr) fail("next {}: no such setting", option);
    const RenderSettings& settings = isOther ? other_.settings : main_.settings;
    std::string next =
        nextChoice(*help, isViewSetting(plain) ? viewSettingValue(state_.view, plain) : settingValue(settings, plain));
    if (next.empty()) fail("next {}: it is a number", option);
    // What the bound takes is known to deferred shading only.
    if (plain == "show" && next == "cut-off" && settings.technique != Technique::Deferred) next = "picture";
    set(option, next);
    if (!isViewSetting(plain)) tell(fmt::format("{}: {}", option, next));
}

}  // namespace manylight
