// The scales of the views can be read by people with every common kind of colour blindness: simulated after
// Machado, Oliveira & Fernandes 2009 (severity 1), and told apart in CIELAB (a difference of 10 is plain to
// see).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "shaders/maths/twin.h"

namespace talus::maths {
namespace {

struct Colours {
    TALUS_TWIN_NAMES(double)
#include "maths/colour_map.glsl"
};

struct Sight {
    const char* name;
    glm::dmat3 rows;  // of linear red, green, blue
};

const Sight sights[] = {
    {"normal", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {"protanopia",
     {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {"deuteranopia",
     {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {"tritanopia",
     {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}};

// CIELAB of a colour as it is seen.
glm::dvec3 seen(glm::dvec3 srgb, const Sight& sight) {
    glm::dvec3 linear;
    for (int i = 0; i < 3; ++i)
        linear[i] = srgb[i] <= 0.04045 ? srgb[i] / 12.92 : std::pow((srgb[i] + 0.055) / 1.055, 2.4);
    linear = glm::clamp(glm::transpose(sight.rows) * linear, 0.0, 1.0);
    const glm::dvec3 xyz(glm::dot(glm::dvec3(0.4124, 0.3576, 0.1805), linear) / 0.9505,
                         glm::dot(glm::dvec3(0.2126, 0.7152, 0.0722), linear),
                         glm::dot(glm::dvec3(0.0193, 0.1192, 0.9505), linear) / 1.089);
    glm::dvec3 f;
    for (int i = 0; i < 3; ++i) f[i] = xyz[i] > 0.008856 ? std::cbrt(xyz[i]) : 7.787 * xyz[i] + 16.0 / 116;
    return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

TEST(ColourMap, DirectionsAreToldApart) {
    Colours colours;
    for (const Sight& sight : sights)
        for (int a = 0; a < 8; ++a)
            for (int b = a + 1; b < 8; ++b) {
                const double apart = glm::distance(seen(colours.direction_map(a / 8.0), sight),
                                                   seen(colours.direction_map(b / 8.0), sight));
                const int turn = std::min(b - a, 8 - (b - a));
                EXPECT_GT(apart, turn == 1 ? 10 : 20) << sight.name << ": " << a << " and " << b;
            }
}

TEST(ColourMap, MoreIsLighter) {
    Colours colours;
    for (const Sight& sight : sights)
        for (int i = 0; i < 16; ++i)
            EXPECT_GT(seen(colours.colour_map((i + 1) / 16.0), sight).x,
                      seen(colours.colour_map(i / 16.0), sight).x + 1)
                << sight.name << ": " << i;
}

TEST(ColourMap, BelowAndAboveAreToldApart) {
    Colours colours;
    for (const Sight& sight : sights)
        for (const double share : {0.1, 0.3, 0.5}) {
            const glm::dvec3 below = seen(colours.difference_map(0.5 - share), sight);
            const glm::dvec3 above = seen(colours.difference_map(0.5 + share), sight);
            EXPECT_GT(glm::distance(below, above), 20) << sight.name << ": " << share;
        }
}

}  // namespace
}  // namespace talus::maths
