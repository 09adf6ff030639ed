#include "app/claims/water_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/terrain/bed_beyond.h"

namespace talus::scenes {
namespace {

constexpr double g = 9.81;

// A strip of n samples, four rows wide, between walls.
WaterScene strip(const std::string& name, int n, double length_m) {
    WaterScene scene;
    scene.name = name;
    scene.grid = {n, 4, length_m / n, length_m / n};
    scene.bed = [](double, double) { return 0.0; };
    return scene;
}

// A bowl z = -h0 (1 - r²/a²), a = 1, h0 = 0.1, in the middle of a square of 4 m.
WaterScene bowl(const std::string& name, int n) {
    WaterScene scene;
    scene.name = name;
    scene.grid = {n, n, 4.0 / n, 4.0 / n};
    scene.bed = [](double x, double y) {
        const double X = x - 2;
        const double Y = y - 2;
        return -0.1 * (1 - (X * X + Y * Y));
    };
    return scene;
}

}  // namespace

WaterSettings scene_settings() {
    WaterSettings settings;
    settings.edges.fill(EdgeKind::wall);
    settings.manning_s_per_m13 = 0;
    settings.wave_height_m = 0;
    settings.sediment.regolith_m_per_s_pa = 0;
    settings.sediment.bedrock_m_per_s_pa = 0;
    settings.sediment.critical_pa = 0;
    return settings;
}

TerrainState WaterScene::state() const {
    std::vector<float> beds;
    std::vector<glm::vec4> start;
    beds.reserve(grid.count());
    start.reserve(grid.count());
    const auto place = [&](int column, int row) {
        return glm::dvec2((column + 0.5) * grid.dx, (grid.ny - 1 - row + 0.5) * grid.dy);
    };
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const glm::dvec2 at = place(column, row);
            const glm::dvec3 w = water(at.x, at.y, 0);
            beds.push_back(static_cast<float>(bed(at.x, at.y)));
            start.emplace_back(w.x, 0, w.y, w.z);
        }
    TerrainState result = bedrock_terrain(grid, beds);
    result.water = start;
    for (int row = 0; manning && row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const glm::dvec2 at = place(column, row);
            result.land_cover.emplace_back(manning(at.x, at.y), 1, 0, 0);
        }
    if (knows_bed_beyond)
        result.bed_beyond = bed_beyond_of(grid, [&](glm::ivec2 sample) {
            const glm::dvec2 at = place(sample.x, sample.y);
            return static_cast<float>(bed(at.x, at.y));
        });
    return result;
}

// Ritter 1892 (Delestre et al. 2013, 4.1.2).
WaterScene ritter(int n) {
    WaterScene scene = strip("Ritter", n, 10);
    scene.tick_s = scene.end_s = 6;
    scene.water = [](double x, double, double t) {
        const double h_l = 0.005;
        const double c = std::sqrt(g * h_l);
        const double s = x - 5;
        if (t <= 0 ? s < 0 : s <= -t * c) return glm::dvec3(h_l, 0, 0);
        if (t <= 0 || s >= 2 * t * c) return glm::dvec3(0);
        const double root = c - s / (2 * t);
        const double h = 4 / (9 * g) * root * root;
        return glm::dvec3(h, h * 2 / 3 * (s / t + c), 0);
    };
    return scene;
}

// Stoker 1957 (Delestre et al. 2013, 4.1.1).
WaterScene stoker(int n) {
    WaterScene scene = strip("Stoker", n, 10);
    scene.tick_s = scene.end_s = 6;
    const double h_l = 0.005;
    const double h_r = 0.001;
    const double c_l = std::sqrt(g * h_l);
    double low = std::sqrt(g * h_r);
    double high = c_l;
    const auto miss = [&](double c) {
        const double s = c * c - g * h_r;
        return -8 * g * h_r * c * c * (c_l - c) * (c_l - c) + s * s * (c * c + g * h_r);
    };
    for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        (miss(middle) < 0 ? low : high) = middle;
    }
    const double c_m = low;
    scene.water = [=](double x, double, double t) {
        const double s = x - 5;
        if (t <= 0) return glm::dvec3(s < 0 ? h_l : h_r, 0, 0);
        const double shock = 2 * c_m * c_m * (c_l - c_m) / (c_m * c_m - g * h_r);
        if (s <= -t * c_l) return glm::dvec3(h_l, 0, 0);
        if (s <= t * (2 * c_l - 3 * c_m)) {
            const double root = c_l - s / (2 * t);
            const double h = 4 / (9 * g) * root * root;
            return glm::dvec3(h, h * 2 / 3 * (s / t + c_l), 0);
        }
        if (s <= t * shock) {
            const double h = c_m * c_m / g;
            return glm::dvec3(h, h * 2 * (c_l - c_m), 0);
        }
        return glm::dvec3(h_r, 0, 0);
    };
    return scene;
}

// Thacker 1981 (Delestre et al. 2013, 4.2.2).
WaterScene thacker_radial(int n) {
    WaterScene scene = bowl("Thacker, radial", n);
    const double h_0 = 0.1;
    const double omega = std::sqrt(8 * g * h_0);
    scene.end_s = 3 * 2 * std::numbers::pi / omega;
    scene.tick_s = scene.end_s / 36;
    scene.water = [=](double x, double y, double t) {
        const double r_0 = 0.8;
        const double A = (1 - r_0 * r_0) / (1 + r_0 * r_0);
        const double D = 1 - A * std::cos(omega * t);
        const double X = x - 2;
        const double Y = y - 2;
        const double h = h_0 * (std::sqrt(1 - A * A) / D - (X * X + Y * Y) * (1 - A * A) / (D * D));
        if (h <= 0) return glm::dvec3(0);
        const double u = 0.5 * omega * A * std::sin(omega * t) / D;
        return glm::dvec3(h, h * u * X, h * u * Y);
    };
    return scene;
}

WaterScene thacker_planar(int n) {
    WaterScene scene = bowl("Thacker, planar", n);
    const double h_0 = 0.1;
    const double eta = 0.5;
    const double omega = std::sqrt(2 * g * h_0);
    scene.end_s = 3 * 2 * std::numbers::pi / omega;
    scene.tick_s = scene.end_s / 36;
    const auto bed = scene.bed;
    scene.water = [=](double x, double y, double t) {
        const double X = x - 2;
        const double Y = y - 2;
        const double level = eta * h_0 * (2 * X * std::cos(omega * t) + 2 * Y * std::sin(omega * t) - eta);
        const double h = level - bed(x, y);
        if (h <= 0) return glm::dvec3(0);
        return glm::dvec3(h, -h * eta * omega * std::sin(omega * t), h * eta * omega * std::cos(omega * t));
    };
    return scene;
}

WaterScene macdonald(int n, bool rough_in_places) {
    WaterScene scene = strip("MacDonald", n, 1000);
    const double q = 2;
    const auto manning = [=](double x) {
        return rough_in_places ? 0.035 - 0.015 * std::cos(2 * std::numbers::pi * x / 1000) : 0.033;
    };
    const auto depth = [](double x) {
        const double s = x / 1000 - 0.5;
        return std::cbrt(4 / g) * (1 + 0.5 * std::exp(-16 * s * s));
    };
    const auto fall = [=](double x) {
        const double h = depth(x);
        const double s = x / 1000 - 0.5;
        const double h_x = std::cbrt(4 / g) * 0.5 * std::exp(-16 * s * s) * (-32 * s / 1000);
        return (q * q / (g * h * h * h) - 1) * h_x - manning(x) * manning(x) * q * q / std::pow(h, 10.0 / 3);
    };
    // The bed by Simpson's rule from the east.
    const auto bed = [=](double x) {
        const int steps = 400;
        const double step = (1000 - x) / steps;
        double sum = 0;
        for (int i = 0; i < steps; ++i) {
            const double a = x + i * step;
            sum += step / 6 * (fall(a) + 4 * fall(a + step / 2) + fall(a + step));
        }
        return -sum;
    };
    scene.bed = [=](double x, double) { return bed(x); };
    scene.water = [=](double x, double, double t) { return glm::dvec3(depth(x), t > 0 ? q : 0, 0); };
    scene.settings.manning_s_per_m13 = manning(0);
    scene.settings.manning_painted = rough_in_places;
    if (rough_in_places) scene.manning = [=](double x, double) { return manning(x); };
    scene.settings.edges[static_cast<std::size_t>(Edge::west)] = EdgeKind::inflow;
    scene.settings.edges[static_cast<std::size_t>(Edge::east)] = EdgeKind::level;
    scene.settings.inflow_m3_per_s = q * scene.grid.ny * scene.grid.dy;
    scene.settings.level_m = bed(1000 - 500.0 / n) + depth(1000);
    scene.tick_s = 60;
    scene.end_s = 3600;
    return scene;
}

// Synolakis 1987: the beach's foot is cot β from the shore, the crest starts where the wave is 1/20 at the
// foot.
WaterScene solitary_on_beach(int n) {
    WaterScene scene = strip("solitary wave", n, 70);
    const double cot = 19.85;
    const double height = 0.019;
    const double gamma = std::sqrt(3 * height / 4);
    const double crest = 10 + cot + std::acosh(std::sqrt(20.0)) / gamma;
    scene.bed = [=](double x, double) { return std::max(-1.0, -(x - 10) / cot); };
    scene.water = [=](double x, double, double) {
        const double c = 1 / std::cosh(gamma * (x - crest));
        const double eta = height * c * c;
        const double h = std::max(0.0, eta + std::min(1.0, (x - 10) / cot));
        // It runs west, as a simple wave.
        return glm::dvec3(h, x > 10 ? -h * 2 * (std::sqrt(g * (1 + eta)) - std::sqrt(g)) : 0, 0);
    };
    scene.tick_s = 0.25;
    scene.end_s = 30;
    return scene;
}

WaterScene small_wave(int n, int waves_x, int waves_y) {
    WaterScene scene;
    scene.name = "small wave";
    scene.grid = {n, n, 640.0 / n, 640.0 / n};
    scene.settings.edges.fill(EdgeKind::periodic);
    scene.bed = [](double, double) { return -7.0; };
    const glm::dvec2 k(2 * std::numbers::pi * waves_x / 640, 2 * std::numbers::pi * waves_y / 640);
    scene.water = [=](double x, double y, double t) {
        const double omega = glm::length(k) * std::sqrt(g * 7);
        const double eta = 0.014 * std::cos(k.x * x + k.y * y - omega * t);
        const double h = 7 + eta;
        const double u = 2 * (std::sqrt(g * h) - std::sqrt(g * 7));
        return glm::dvec3(h, h * u * k.x / glm::length(k), h * u * k.y / glm::length(k));
    };
    scene.tick_s = 1;
    scene.end_s = 100;
    return scene;
}

WaterScene rain_on_slope(double slope, int order) {
    WaterScene scene;
    scene.name = "rain on a slope";
    scene.grid = {64, 16, 30, 30};
    scene.settings.order = order;
    scene.settings.manning_s_per_m13 = 0.03;
    scene.settings.rain_m_per_s = 20e-3 / 3600;
    scene.settings.edges = {EdgeKind::periodic, EdgeKind::periodic, EdgeKind::wall, EdgeKind::open};
    scene.bed = [=](double x, double y) {
        // Two neighbours' offsets differ by up to a fifth of the drop between them.
        const double noise = std::sin(x * 12.9898 + y * 78.233) * 43758.5453;
        return 2000 - slope * x + 0.2 * slope * 30 * (noise - std::floor(noise) - 0.5);
    };
    scene.water = [=](double x, double, double t) {
        if (t <= 0) return glm::dvec3(0);
        const double q = 20e-3 / 3600 * x;
        return glm::dvec3(std::pow(0.03 * q / std::sqrt(slope), 0.6), q, 0);
    };
    scene.tick_s = 60;
    scene.end_s = 7200;
    return scene;
}

WaterScene rain_on_bowl(double datum_m, int order) {
    WaterScene scene;
    scene.name = "rain on a bowl";
    scene.grid = {128, 96, 20, 20};
    scene.settings.order = order;
    scene.settings.edges.fill(EdgeKind::open);
    scene.settings.manning_s_per_m13 = 0.035;
    scene.settings.rain_m_per_s = 0.2 / 3600;
    scene.bed = [=](double x, double y) {
        const double from_middle = std::hypot(x - 1280, y - 960);
        return datum_m + 0.15 * from_middle + 4 * std::sin(x / 70) * std::cos(y / 90);
    };
    scene.water = [](double, double, double) { return glm::dvec3(0); };
    scene.tick_s = 2;
    scene.end_s = 900;
    return scene;
}

WaterScene lake(int n, double datum_m) {
    WaterScene scene;
    scene.name = "lake at rest";
    scene.grid = {n, n, 10, 10};
    scene.bed = [=](double x, double y) {
        const double extent = n * 10;
        const double bump =
            14 * std::exp(-(std::pow(x / extent - 0.35, 2) + std::pow(y / extent - 0.6, 2)) / 0.01);
        const double other =
            11 * std::exp(-(std::pow(x / extent - 0.7, 2) + std::pow(y / extent - 0.3, 2)) / 0.02);
        return datum_m + bump + other + 0.7 * std::sin(x / 7) * std::cos(y / 9) +
               0.05 * std::sin(x) * std::sin(1.3 * y);
    };
    // What is there above the bed as it is stored, or the start is not at rest.
    const auto bed = scene.bed;
    scene.water = [=](double x, double y, double) {
        const double level = datum_m + 8;
        return glm::dvec3(std::max(0.0, level - static_cast<double>(static_cast<float>(bed(x, y)))), 0, 0);
    };
    return scene;
}

WaterScene basin(int n, int seed) {
    WaterScene scene;
    scene.name = "closed basin";
    scene.grid = {n, n, 5, 5};
    scene.bed = [=](double x, double y) {
        const double p = 0.031 * (1 + 0.1 * seed);
        return 3 * std::sin(p * x) * std::cos(0.027 * y) + 0.02 * x +
               1.2 * std::sin(0.11 * x + 0.07 * y + seed);
    };
    const auto bed = scene.bed;
    scene.water = [=](double x, double y, double) {
        const double level = x < 2.0 * n ? 9.0 : 1.0;
        return glm::dvec3(std::max(0.0, level - bed(x, y)), 0, 0);
    };
    return scene;
}

WaterScene radial_dam(int n, bool rough) {
    WaterScene scene;
    scene.name = "radial dam break";
    scene.grid = {n, n, 1, 1};
    const double middle = n / 2.0;
    scene.bed = [=](double x, double y) {
        if (!rough) return 0.0;
        const double X = x - middle;
        const double Y = y - middle;
        // Squares and their product: the same bits for (X, Y), (-X, Y) and (Y, X).
        const double a = X * X + Y * Y;
        const double b = X * X * (Y * Y);
        return 0.5 * std::sin(0.01 * a) + 0.4 * std::sin(0.0005 * b) + 0.002 * a;
    };
    scene.water = [=](double x, double y, double) {
        const double r2 = (x - middle) * (x - middle) + (y - middle) * (y - middle);
        return glm::dvec3(r2 < n * n / 25.0 ? 4 : (rough ? 0 : 0.5), 0, 0);
    };
    return scene;
}

WaterRun::WaterRun(const TerrainState& state, const WaterSettings& s)
    : terrain(state), settings(s), water((terrain.add(&Terrain::water), terrain)) {
    if (settings.sediment.carried) terrain.add(&Terrain::suspended);
    if (settings.counts_maps) {
        terrain.add(&Terrain::flow);
        if (settings.sediment.carried) terrain.add(&Terrain::worn_by_water);
    }
}

void WaterRun::tick(double tick_s) {
    water.begin_tick(terrain, settings, springs, tick_s, time_s_);
    while (water.time_left_s() > 0)
        for (int i = 0; i < 8; ++i) water.substep(terrain);
    time_s_ += tick_s;
}

void WaterRun::run(double tick_s, double end_s) {
    const double ticks = std::ceil((end_s - time_s_) / tick_s - 1e-9);
    const double each = (end_s - time_s_) / ticks;
    for (int i = 0; i < ticks; ++i) tick(each);
}

double depth_error(const WaterScene& scene, const TerrainState& state, double time_s) {
    double missed = 0;
    double all = 0;
    const Grid& grid = scene.grid;
    for (int row = 0; row < grid.ny; ++row)
        for (int column = 0; column < grid.nx; ++column) {
            const double exact =
                scene.water((column + 0.5) * grid.dx, (grid.ny - 1 - row + 0.5) * grid.dy, time_s).x;
            const glm::vec4& texel = state.water[static_cast<std::size_t>(row) * grid.nx + column];
            missed += std::abs(static_cast<double>(texel.x) + texel.y - exact);
            all += exact;
        }
    return missed / all;
}

}  // namespace talus::scenes
