// Figures and texts of panels: as people write them, and within their panel.
#include "app/panels/widgets.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "app/panels/style.h"

namespace talus::widgets_test {
namespace {

TEST(Widgets, FiguresHaveNoExponentWherePeopleWriteNone) {
    for (const auto& [value, digits, wanted] : {std::tuple{10000.0, 3, "10000"},
                                                {1e4, 4, "10000"},
                                                {123456.7, 3, "123457"},
                                                {-25000.0, 3, "-25000"},
                                                {0.0001, 3, "0.0001"},
                                                {1234.5678, 6, "1234.57"},
                                                {-0.0, 3, "0"},
                                                {0.0, 3, "0"},
                                                {999.9, 3, "1000"},
                                                {9999.7, 3, "10000"},
                                                {99999.7, 5, "100000"},
                                                {-999.9, 3, "-1000"},
                                                {999999999999999.0, 3, "999999999999999"},
                                                {1e15, 3, "1e+15"},
                                                {0.00001, 3, "1e-05"}})
        EXPECT_EQ(figure(value, digits), wanted);
}

TEST(Widgets, ShortenedTextsKeepWholeLetters) {
    const std::string text = "30 × 20 m³ über Höhe …";
    for (std::size_t bytes = 0; bytes <= text.size(); ++bytes) {
        const std::string shown =
            app::shortened(text, [=](const std::string& some) { return some.size() <= bytes; });
        // The ellipsis alone is left where nothing fits.
        EXPECT_LE(shown.size(), std::max<std::size_t>(bytes, 3));
        if (bytes == text.size()) {
            EXPECT_EQ(shown, text);
            continue;
        }
        const std::string kept = shown.substr(0, shown.size() - 3);
        EXPECT_EQ(shown, kept + "…");
        EXPECT_TRUE(text.starts_with(kept));
        // A letter more would not have fitted.
        std::size_t next = kept.size() + 1;
        while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0U) == 0x80U) ++next;
        EXPECT_GT(next + 3, bytes);
        // What follows begins a letter.
        EXPECT_NE(static_cast<unsigned char>(text[kept.size()]) & 0xC0U, 0x80U) << bytes;
    }
}

// A text that is wider than its panel ends within it, by an ellipsis and never in half a letter; one that
// fits is whole.
TEST(Widgets, TextsEndWithinTheirPanel) {
    ImGuiContext* const context = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {640, 480};
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    const std::string text = "a stamp of dunes, 1024 × 1024 samples, 30 km wide and 400 m high";
    for (const float panel_width : {80.0F, 160.0F, 320.0F, 600.0F}) {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({panel_width, 200});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoSavedSettings);
        const float right = ImGui::GetWindowContentRegionMax().x;
        app::text_line(text);
        EXPECT_LE(ImGui::GetItemRectMax().x, right + 0.5F) << panel_width;
        EXPECT_GT(ImGui::GetItemRectSize().x, 20) << panel_width;
        const float whole = ImGui::CalcTextSize(text.c_str()).x;
        if (whole <= right - ImGui::GetCursorStartPos().x) {
            EXPECT_FLOAT_EQ(ImGui::GetItemRectSize().x, whole);
        }
        app::figure_line("stamp", text);
        EXPECT_LE(ImGui::GetItemRectMax().x, right + 0.5F) << panel_width;
        ImGui::End();
        ImGui::EndFrame();
    }
    ImGui::DestroyContext(context);
}

// Contrast of two colours, from 1 to 21 (WCAG 2.1, "contrast ratio" and "relative luminance").
double contrast(glm::vec4 a, glm::vec4 b) {
    const auto luminance = [](glm::vec4 colour) {
        const auto linear = [](double c) {
            return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
    };
    const double first = luminance(a) + 0.05;
    const double second = luminance(b) + 0.05;
    return std::max(first, second) / std::min(first, second);
}

// Text has the contrast that WCAG 2.1 asks for on level AA (4.5), and of high contrast on level AAA (7).
TEST(Widgets, TextsCanBeReadInEveryTheme) {
    for (const app::Theme& one : app::themes()) {
        const double least = std::string(one.name) == "high contrast" ? 7 : 4.5;
        for (const glm::vec4 ground : {one.panel, one.popup, one.field, one.button, one.bar}) {
            EXPECT_GE(contrast(one.text, ground), least) << one.name;
            EXPECT_GE(contrast(one.heading, ground), least) << one.name;
            EXPECT_GE(contrast(one.warning, ground), least) << one.name;
        }
        for (const glm::vec4 ground : {one.chosen, one.hovered, one.notice})
            EXPECT_GE(contrast(one.text, ground), least) << one.name;
        for (const glm::vec4 ground : {one.panel, one.popup})
            EXPECT_GE(contrast(one.faint, ground), least) << one.name;
        EXPECT_GE(contrast(one.handle, one.field), 3) << one.name;
        EXPECT_GE(contrast(one.text, one.handle), 4) << one.name;
    }
}

}  // namespace
}  // namespace talus::widgets_test
