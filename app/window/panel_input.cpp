#include "app/window/panel_input.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace talus::app {

PanelInput::PanelInput(GLFWwindow* window, std::function<void(const InputEvents::Key&)> shortcut)
    : window_(window),
      to_{std::move(shortcut),
          [window](const InputEvents::Key& key) {
              ImGui_ImplGlfw_KeyCallback(window, key.key, key.code, key.action, key.mods);
          },
          [window](unsigned letter) { ImGui_ImplGlfw_CharCallback(window, letter); },
          [this](const InputEvents::Button& heard) {
              if (heard.button >= static_cast<int>(down_.size())) return;
              down_[heard.button] = heard.down;
              ImGui::GetIO().MousePos = {static_cast<float>(heard.at.x), static_cast<float>(heard.at.y)};
          }} {}

void PanelInput::hear_button(int button, int action) {
    InputEvents::Button heard{button, action == GLFW_PRESS, {}};
    glfwGetCursorPos(window_, &heard.at.x, &heard.at.y);
    events_.hear_button(heard);
}

bool PanelInput::pass() {
    waits_ = events_.pass(to_);
    // The buttons that the backend read from GLFW may be ahead of the keys.
    std::copy(down_.begin(), down_.end(), std::begin(ImGui::GetIO().MouseDown));
    return waits_;
}

}  // namespace talus::app
