#pragma once
#include <array>
#include <optional>
#include <string>

#include "sim/gpu/handle.h"

namespace talus::gpu {

void delete_query(unsigned name);

/// Milliseconds between two queries of GL_TIMESTAMP, the later one last; none while the device has not passed
/// it.
std::optional<double> milliseconds_between(const Handle<delete_query>& first,
                                           const Handle<delete_query>& last);

/// The device time between begin() and end(), in milliseconds, read when it is ready and never waited for.
/// (Pairs of GL_TIMESTAMP: GL_TIME_ELAPSED reads 0 for compute work on llvmpipe.)
class Timestamp {
  public:
    explicit Timestamp(const std::string& label);

    void begin();
    void end();
    /// True while a span was ended and not yet told.
    bool pending() const;
    /// The newest span whose end the device has passed since the last call.
    std::optional<double> milliseconds();

  private:
    struct Span {
        Handle<delete_query> first;
        Handle<delete_query> last;
        bool pending = false;
    };
    std::array<Span, 4> spans_;
    int next_ = 0;
};

}  // namespace talus::gpu
