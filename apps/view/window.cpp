#include "apps/view/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

namespace manylight {
namespace {

constexpr const char* kHint = "manylight-capture renders without a window";

std::string glfwProblem() {
    const char* text = nullptr;
    glfwGetError(&text);
    std::string reason = text != nullptr ? text : "no reason given";
    while (!reason.empty() && reason.back() == ' ') reason.pop_back();
    return reason;
}

/// Ends GLFW again if a constructor fails half way.
struct Library {
    Library() {
        if (glfwInit() != GLFW_TRUE) fail("no display to open a window on ({}); {}", glfwProblem(), kHint);
    }
    ~Library() {
        if (owns) glfwTerminate();
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    bool owns = true;
};

void onDrop(GLFWwindow* window, int count, const char** paths) {
    auto* dropped = static_cast<std::vector<std::filesystem::path>*>(glfwGetWindowUserPointer(window));
    for (int i = 0; i < count; ++i) dropped->emplace_back(paths[i]);
}

}  // namespace

Window::Window(const std::string& title, glm::uvec2 size) {
    Library library;
    if (glfwVulkanSupported() != GLFW_TRUE) fail("Vulkan cannot draw to windows of this display; {}", kHint);
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    window_ = glfwCreateWindow(static_cast<int>(size.x), static_cast<int>(size.y), title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) fail("no window of {}x{} could be opened ({}); {}", size.x, size.y, glfwProblem(), kHint);
    glfwSetWindowSizeLimits(window_, 64, 48, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(window_, &dropped_);
    glfwSetDropCallback(window_, onDrop);
    library.owns = false;
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

gpu::WindowSystem Window::system() const {
    uint32_t count = 0;
    const char** names = glfwGetRequiredInstanceExtensions(&count);
    if (names == nullptr) fail("Vulkan cannot draw to windows of this display; {}", kHint);
    return {{names, names + count}, [](VkInstance instance, VkPhysicalDevice device, uint32_t family) {
                return glfwGetPhysicalDevicePresentationSupport(instance, device, family) == GLFW_TRUE;
            }};
}

VkSurfaceKHR Window::createSurface(gpu::Device& device) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    gpu::check(glfwCreateWindowSurface(device.instance().handle(), window_, nullptr, &surface),
               "connecting to the window");
    VkBool32 supported = VK_FALSE;
    vkGetPhysicalDeviceSurfaceSupportKHR(device.physicalDevice(), device.queueFamily(), surface, &supported);
    if (supported == VK_FALSE)
        fail("device {} has no queue that presents to this window; {}", device.info().name, kHint);
    return surface;
}

void Window::poll(double seconds) {
    if (seconds > 0.0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

bool Window::shouldClose() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }
void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

bool Window::isMinimised() const {
    const glm::uvec2 size = framebufferSize();
    return isMadeMinimised_ || size.x == 0 || size.y == 0 || glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
}

void Window::minimise() {
    glfwIconifyWindow(window_);
    isMadeMinimised_ = true;
}

void Window::restore() {
    glfwRestoreWindow(window_);
    isMadeMinimised_ = false;
}

glm::uvec2 Window::framebufferSize() const {
    glm::ivec2 size{0};
    if (isMadeMinimised_) return size;
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

void Window::resize(glm::uvec2 size) { glfwSetWindowSize(window_, static_cast<int>(size.x), static_cast<int>(size.y)); }
void Window::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

float Window::contentScale() const {
    float x = 1.0f;
    float y = 1.0f;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max(x, 1.0f);
}

float Window::pixelsPerUnit() const {
    glm::ivec2 pixels{0};
    glm::ivec2 units{0};
    glfwGetFramebufferSize(window_, &pixels.x, &pixels.y);
    glfwGetWindowSize(window_, &units.x, &units.y);
    return pixels.x > 0 && units.x > 0 ? static_cast<float>(pixels.x) / static_cast<float>(units.x) : 1.0f;
}

void Window::drop(const std::vector<std::string>& files) {
    std::vector<const char*> paths;
    for (const std::string& file : files) paths.push_back(file.c_str());
    onDrop(window_, static_cast<int>(paths.size()), paths.data());
}

std::vector<std::filesystem::path> Window::takeDroppedFiles() { return std::exchange(dropped_, {}); }

}  // namespace manylight
