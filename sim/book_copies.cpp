#include "sim/book_copies.h"

#include <algorithm>
#include <numeric>

namespace talus {

BookCopies::BookCopies(const std::vector<Book>& books) {
    copies_.reserve(books.size());
    for (const Book& book : books) {
        copies_.push_back({book.name, book.add, gpu::Buffer("copy of a book", book.words->bytes())});
        copies_.back().words.copy_from(*book.words);
    }
}

void BookCopies::put_back(const std::vector<Book>& books) const {
    for (const Book& book : books) {
        const auto copy = std::find_if(copies_.begin(), copies_.end(),
                                       [&](const Copy& one) { return one.name == book.name; });
        if (copy == copies_.end())
            book.words->fill(0);
        else
            book.words->copy_from(copy->words);
    }
}

BudgetTerms BookCopies::terms(const Grid& grid, const SolidWeights& weights) const {
    BudgetTerms terms;
    for (const Copy& copy : copies_) copy.add(copy.words, grid, weights, terms);
    return terms;
}

std::size_t BookCopies::bytes() const {
    return std::accumulate(copies_.begin(), copies_.end(), std::size_t{0},
                           [](std::size_t sum, const Copy& copy) { return sum + copy.words.bytes(); });
}

}  // namespace talus
