#include "sim/gpu/timestamp.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "sim/gpu/debug.h"

namespace talus::gpu {

void delete_query(unsigned name) {
    glDeleteQueries(1, &name);
}

std::optional<double> milliseconds_between(const Handle<delete_query>& first,
                                           const Handle<delete_query>& last) {
    GLint ready = 0;
    glGetQueryObjectiv(last, GL_QUERY_RESULT_AVAILABLE, &ready);
    if (!ready) return std::nullopt;
    GLuint64 begin = 0;
    GLuint64 end = 0;
    glGetQueryObjectui64v(first, GL_QUERY_RESULT, &begin);
    glGetQueryObjectui64v(last, GL_QUERY_RESULT, &end);
    return static_cast<double>(end - begin) * 1e-6;
}

Timestamp::Timestamp(const std::string& label) {
    for (Span& span : spans_) {
        for (Handle<delete_query>* query : {&span.first, &span.last}) {
            GLuint name = 0;
            glCreateQueries(GL_TIMESTAMP, 1, &name);
            *query = Handle<delete_query>(name);
            glObjectLabel(GL_QUERY, name, static_cast<GLsizei>(label.size()), label.data());
        }
    }
    raise_errors();
}

void Timestamp::begin() {
    glQueryCounter(spans_[next_].first, GL_TIMESTAMP);
}

void Timestamp::end() {
    glQueryCounter(spans_[next_].last, GL_TIMESTAMP);
    spans_[next_].pending = true;
    next_ = (next_ + 1) % static_cast<int>(spans_.size());
}

bool Timestamp::pending() const {
    return std::any_of(spans_.begin(), spans_.end(), [](const Span& span) { return span.pending; });
}

std::optional<double> Timestamp::milliseconds() {
    std::optional<double> latest;
    for (std::size_t i = 0; i < spans_.size(); ++i) {
        Span& span = spans_[(next_ + i) % spans_.size()];
        if (!span.pending) continue;
        const std::optional<double> ms = milliseconds_between(span.first, span.last);
        if (!ms) break;
        span.pending = false;
        latest = ms;
    }
    return latest;
}

}  // namespace talus::gpu
