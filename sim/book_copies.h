#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "sim/budget.h"
#include "sim/gpu/buffer.h"

namespace talus {

/// Copies of books, as they stood at one moment. Making them and putting them back does not wait.
class BookCopies {
  public:
    BookCopies() = default;
    explicit BookCopies(const std::vector<Book>& books);

    /// The books hold again what they held. A book that was begun later held nothing.
    void put_back(const std::vector<Book>& books) const;
    /// What they say. Waits for the device.
    BudgetTerms terms(const Grid& grid, const SolidWeights& weights) const;
    std::size_t bytes() const;

  private:
    struct Copy {
        std::string name;
        Book::Add add;
        gpu::Buffer words;
    };
    std::vector<Copy> copies_;
};

}  // namespace talus
