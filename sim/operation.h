#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "sim/parameters.h"
#include "sim/passes/dab.h"
#include "sim/passes/mask_settings.h"
#include "sim/terrain/reshape.h"
#include "sim/terrain/stamp.h"
#include "sim/terrain/terrain_state.h"

namespace talus {

/// A number of whole ticks.
struct Ticks {
    std::int64_t count = 1;
    bool operator==(const Ticks&) const = default;
};

/// A change of one simulation parameter.
struct SetParameter {
    std::string name;
    std::optional<Value> value;  ///< none: unset, so that it is the default or follows another parameter
    bool operator==(const SetParameter&) const = default;
};

/// A spring is placed; at the sample of another one it takes its place, and with rate 0 there is none.
using PlaceSpring = Spring;

/// A parameter follows a table against simulated time from now on (sim/drives.h); with an empty table it
/// follows none any more, and stays as it is.
using DriveParameter = Drive;

/// What happens by itself (sim/events.h) is this from now on; what is done among it is not done again.
struct SetEvents {
    std::vector<Event> events;
    bool operator==(const SetEvents&) const = default;
};

/// Another number of samples over the same extent.
struct Resample {
    int nx = 0;
    int ny = 0;
    std::shared_ptr<const TerrainState> made =
        nullptr;  ///< the present terrain so; none: the simulation makes it
    bool operator==(const Resample& other) const { return nx == other.nx && ny == other.ny; }
};

/// What lies in a rectangle becomes the terrain; its south-west sample becomes the origin.
struct Crop {
    Rectangle rectangle;
    std::shared_ptr<const TerrainState> made = nullptr;  ///< as of Resample
    bool operator==(const Crop& other) const { return rectangle == other.rectangle; }
};

/// The terrain turns by quarters of a circle, counterclockwise, and with it the kinds of its edges.
struct Turn {
    int quarters = 1;
    std::shared_ptr<const TerrainState> made = nullptr;  ///< as of Resample
    bool operator==(const Turn& other) const { return quarters == other.quarters; }
};

/// A file that an operation reads. What it holds comes with the operation (app/core/sources.h): the
/// simulation reads no files.
struct Source {
    std::string path;
    std::string import_guess;  ///< how it was read, as the app's import settings write themselves
    std::uint64_t hash = 0;    ///< of the terrain in it
    bool operator==(const Source&) const = default;
};

/// A file's terrain takes the place of this one; clock and parameters go on.
struct Import {
    Source source;
    std::shared_ptr<const TerrainState> state;  ///< what the file holds
    bool operator==(const Import& other) const { return source == other.source; }
};

/// A source's path that begins so names a stamp that Talus makes (sim/terrain/stamp_shapes.h).
inline const std::string stamp_shelf = "shelf:";

/// What dabs of a stamp press into the ground from now on: a file's heights, a stamp of the shelf, or,
/// without a path, a piece of this terrain as it is now.
struct ChooseStamp {
    Source source;
    Rectangle piece;
    std::shared_ptr<const Stamp> stamp;  ///< what the file holds
    bool operator==(const ChooseStamp& other) const { return source == other.source && piece == other.piece; }
};

/// The painted mask becomes a function of the terrain, or of itself (shaders/maths/mask.glsl,
/// sim/passes/mask_settings.h).
using MakeMask = MaskSettings;

/// The ground is blurred by a Gaussian of this standard deviation, or the mask is.
struct Blur {
    double deviation_m = 0;
    bool of_mask = false;
    bool masked = false;                                 ///< the ground: as far as the mask says
    std::shared_ptr<const TerrainState> made = nullptr;  ///< as of Resample
    bool operator==(const Blur& other) const {
        return deviation_m == other.deviation_m && of_mask == other.of_mask && masked == other.masked;
    }
};

/// A painted number becomes what a raster says, where that says anything (sim/terrain/painted_numbers.h).
struct TakeRaster {
    std::string number;
    Source source;                                     ///< its hash is that of the values
    std::shared_ptr<const std::vector<float>> values;  ///< of each sample; NaN: the raster says nothing there
    bool operator==(const TakeRaster& other) const {
        return number == other.number && source == other.source;
    }
};

/// One recorded act. Replaying a list of them gives the same terrain.
using Operation = std::variant<Ticks, Dab, SetParameter, PlaceSpring, DriveParameter, SetEvents, Resample,
                               Crop, Turn, Import, ChooseStamp, MakeMask, Blur, TakeRaster>;

/// What acts on the whole map make of a terrain, on the CPU alone. Throw talus::Error where that cannot be.
TerrainState made_of(const Resample& to, const TerrainState& state);
TerrainState made_of(const Crop& crop, const TerrainState& state);
TerrainState made_of(const Turn& turn, const TerrainState& state);
TerrainState made_of(const Blur& blur, const TerrainState& state);

/// Whether it makes another terrain that way, which may take long.
bool makes_terrain(const Operation& operation);
/// The operation with its result already computed by made_of(), so that a background task can do the work. A
/// simulation in this state only takes the result over.
Operation made_ready(Operation operation, const TerrainState& state);

/// Lets go of what was made ready, or came from files.
void forget_made(Operation& operation);

/// What a history calls it, e.g. "resample to 513 x 513".
std::string name_of(const Operation& operation);

}  // namespace talus
