#pragma once
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

/// Lets the files of shaders/maths compile as C++ inside a class template:
///
///     template <typename Real>
///     struct ThermalTwin : TwinTypes<Real> {
///         TALUS_TWIN_NAMES(Real)
///         real4 load_solid(int2 at) const;
///     #include "maths/thermal.glsl"
///     };
///
/// Scalars in float round as llvmpipe does (law 4): `precise` there, -ffp-contract=off here.
#define precise

namespace talus::maths {

using std::abs;
using std::floor;
using std::sqrt;
template <typename T>
constexpr T min(T a, T b) {
    return b < a ? b : a;
}
template <typename T>
constexpr T max(T a, T b) {
    return a < b ? b : a;
}

// In a uniform block a pair begins at a multiple of its size; three or four numbers of four at one of four.
template <typename T>
constexpr std::size_t std140_alignment() {
    return sizeof(T) <= 8 ? sizeof(T) : 16;
}

}  // namespace talus::maths

/// A line NUMBER(type, name) of a file of numbers as a member of a struct, where std140 puts it in a uniform
/// block: `#define NUMBER TALUS_MEMBER` before the file is included, `#undef NUMBER` after it.
#define TALUS_MEMBER(type, name) alignas(talus::maths::std140_alignment<type>()) type name{};

/// The same line as a copy of that member of `numbers` into one of its name here, which may be of double.
#define TALUS_TAKE(type, name) name = type(numbers.name);

#define TALUS_TWIN_NAMES(Real)       \
    using real = Real;               \
    using real2 = glm::vec<2, Real>; \
    using real3 = glm::vec<3, Real>; \
    using real4 = glm::vec<4, Real>; \
    using int2 = glm::ivec2;         \
    using uint = unsigned;
