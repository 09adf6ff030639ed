// PNG and EXR by OpenImageIO.
#include "sim/io/picture.h"

#include <OpenImageIO/filesystem.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sim/error.h"
#include "sim/io/atomic_file.h"
#include "sim/io/endings.h"
#include "sim/io/heightmap_formats.h"

namespace talus::io {
namespace {

namespace fs = std::filesystem;

std::string one_line(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
    return message.empty() ? "the file is damaged or of another kind" : message;
}

// libpng writes messages of its own to stderr, before ours says the same of the file by name.
class QuietStderr {
  public:
    QuietStderr() : kept_(::dup(STDERR_FILENO)) {
        const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nothing < 0) return;
        ::dup2(nothing, STDERR_FILENO);
        ::close(nothing);
    }
    ~QuietStderr() {
        if (kept_ < 0) return;
        ::dup2(kept_, STDERR_FILENO);
        ::close(kept_);
    }
    QuietStderr(const QuietStderr&) = delete;
    QuietStderr& operator=(const QuietStderr&) = delete;

  private:
    int kept_;
};

}  // namespace

std::unique_ptr<OIIO::ImageInput> open_picture(const fs::path& path) {
    const QuietStderr quiet;
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    auto input = OIIO::ImageInput::open(path.string(), &wish);
    if (!input)
        throw Error(fmt::format("'{}' cannot be read: {}", path.string(), one_line(OIIO::geterror())));
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.nchannels < 1 || spec.nchannels > 64)
        throw Error(fmt::format("'{}' has {} channels, 1 to 64 can be read", path.string(), spec.nchannels));
    // Deflate packs at most 1032 to 1, and a pixel of few colours takes a bit at least: a PNG that claims
    // more than that holds less than it says.
    if (ending_of(path) == ".png" && spec.image_pixels() / 8 / 1100 > fs::file_size(path))
        throw Error(fmt::format("'{}' claims {} x {} samples but its {} bytes cannot hold them",
                                path.string(), spec.width, spec.height, fs::file_size(path)));
    return input;
}

void read_bytes(const fs::path& path, OIIO::ImageInput& input, int channels, std::uint8_t* bytes) {
    const QuietStderr quiet;
    if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, bytes))
        throw Error(fmt::format("'{}' cannot be read: {}", path.string(), one_line(input.geterror())));
}

double number_attribute(const fs::path& path, const OIIO::ImageSpec& spec, const char* name,
                        double fallback) {
    const std::string text = spec.get_string_attribute(name);
    if (text.empty()) return fallback;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        throw Error(fmt::format("'{}': its attribute {} = '{}' is not a number", path.string(), name, text));
    return value;
}

void write_encoded(const fs::path& path, const OIIO::ImageSpec& spec, const void* pixels) {
    std::vector<unsigned char> content;
    OIIO::Filesystem::IOVecOutput memory(content);
    auto output = OIIO::ImageOutput::create(path.string(), &memory);
    if (!output || !output->supports("ioproxy"))
        throw Error(fmt::format("cannot write '{}': OpenImageIO does not encode {} in memory", path.string(),
                                ending_of(path)));
    output->set_ioproxy(&memory);
    if (!output->open(path.string(), spec) || !output->write_image(spec.format, pixels) || !output->close())
        throw Error(fmt::format("cannot write '{}': {}", path.string(), one_line(output->geterror())));
    write_atomically(path, std::as_bytes(std::span(content)));
}

Heightmap read_picture(const fs::path& path, const ImportSettings& settings) {
    const auto input = open_picture(path);
    const OIIO::ImageSpec spec = input->spec();
    check_file_size(path, spec.width, spec.height);
    Heightmap heightmap;
    heightmap.grid = {spec.width, spec.height, 1, 1};
    heightmap.heights.resize(heightmap.grid.count());
    const bool floats = spec.format.is_floating_point();
    heightmap.kind =
        fmt::format("{}, {}", ending_of(path) == ".png" ? "PNG" : "EXR",
                    floats ? (spec.format == OIIO::TypeDesc::HALF ? "16-bit float" : "32-bit float")
                           : fmt::format("{}-bit integer", 8 * spec.format.size()));
    // Where there are several channels, the one that pictures show.
    int channel = 0;
    for (const char* name : {"Y", "R", "ground", "height", "Z"}) {
        const int found = spec.channelindex(name);
        if (found < 0) continue;
        channel = found;
        break;
    }
    if (spec.nchannels > 1)
        heightmap.notes.push_back(fmt::format("the file has {} channels, '{}' was read", spec.nchannels,
                                              spec.channelnames[channel]));
    {
        const QuietStderr quiet;
        // As integers: OpenImageIO's floats of 0 to 1 would cost the last bits of 65535.
        std::vector<std::uint16_t> integers(floats ? 0 : heightmap.grid.count());
        const bool ok =
            floats ? input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT,
                                       heightmap.heights.data())
                   : input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::UINT16, integers.data());
        if (!ok)
            throw Error(fmt::format("'{}' cannot be read: {}", path.string(), one_line(input->geterror())));
        std::copy(integers.begin(), integers.end(), heightmap.heights.begin());
    }
    check_finite(path, heightmap);

    const std::optional<Sidecar> sidecar = read_sidecar(path, heightmap.notes);
    if (sidecar && sidecar->dx && sidecar->dy) {
        heightmap.grid.dx = *sidecar->dx;
        heightmap.grid.dy = *sidecar->dy;
        heightmap.georeference = sidecar->georeference;
    } else if (spec.find_attribute("talus:dx_m")) {
        heightmap.grid.dx = number_attribute(path, spec, "talus:dx_m", 1);
        heightmap.grid.dy = number_attribute(path, spec, "talus:dy_m", 1);
    } else if (!settings.spacing_m) {
        heightmap.notes.push_back("the file says no spacing, 1 m a sample was taken: --spacing sets it");
    }
    if (settings.spacing_m) heightmap.grid.dx = heightmap.grid.dy = *settings.spacing_m;
    if (floats) {
        scale_floats(heightmap, settings);
        return heightmap;
    }
    std::optional<Range> own = sidecar ? sidecar->range : std::nullopt;
    const std::string written = spec.get_string_attribute("talus:range_m");
    double low = 0;
    double high = 0;
    if (!own && std::sscanf(written.c_str(), "%lf,%lf", &low, &high) == 2) own = Range(low, high);
    scale_integers(heightmap, 65535, own, settings);
    return heightmap;
}

void write_picture(const fs::path& path, const Heightmap& heightmap, std::optional<Range> range) {
    OIIO::ImageSpec spec(heightmap.grid.nx, heightmap.grid.ny, 1, OIIO::TypeDesc::FLOAT);
    spec.attribute("talus:dx_m", fmt::format("{}", heightmap.grid.dx));
    spec.attribute("talus:dy_m", fmt::format("{}", heightmap.grid.dy));
    if (ending_of(path) == ".exr") {
        spec.channelnames = {"Y"};
        spec.attribute("compression", "zip");
        return write_encoded(path, spec, heightmap.heights.data());
    }
    const Range used = range_for(heightmap, range);
    spec.set_format(OIIO::TypeDesc::UINT16);
    spec.attribute("talus:range_m", fmt::format("{},{}", used.x, used.y));
    const std::vector<std::uint16_t> values = quantise(heightmap, used);
    write_encoded(path, spec, values.data());
    write_sidecar(path, heightmap, "uint16", used);
}

}  // namespace talus::io
