#include "sim/gpu/timestamp.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "sim/gpu/debug.h"

namespace talus::gpu {

void delete_query(unsigned name) {
    glDeleteQueries(1, &name);
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
        GLint ready = 0;
        glGetQueryObjectiv(span.last, GL_QUERY_RESULT_AVAILABLE, &ready);
        if (!ready) break;
        GLuint64 first = 0;
        GLuint64 last = 0;
        glGetQueryObjectui64v(span.first, GL_QUERY_RESULT, &first);
        glGetQueryObjectui64v(span.last, GL_QUERY_RESULT, &last);
        span.pending = false;
        latest = static_cast<double>(last - first) * 1e-6;
    }
    return latest;
}

}  // namespace talus::gpu
