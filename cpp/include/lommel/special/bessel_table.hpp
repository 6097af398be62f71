// Table of the Bessel functions 2 (-1)^n J_{2n+1}(v) / v as polynomials on pieces of the axis of v, the radius in units of
// lambda / (2 pi NA). It depends only on the width of the pieces, so one table serves all pupils, wavelengths and pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/special/piece.hpp"

namespace lommel {

// Permitted widths of the table's pieces, in v (radius in units of lambda / (2 pi NA)). Wider pieces have a larger
// interpolation error and larger coefficients, which amplify rounding.
constexpr std::array<double, 7> widths = {12.0, 9.6, 8.0, 6.4, 5.2, 4.2, 3.2};

// Bound, relative to sup|U|, on the error of interpolating the field U at 16 Chebyshev points of a piece of width H:
// 2 (H/4)^16 / 16!, as the 16th derivative of U is at most sup|U| (Bernstein's inequality: U is of exponential type 1).
inline double piece_error(double width) { return 2.0 * std::pow(0.25 * width, 16) / 20922789888000.0; }

struct PieceTable {
    double width = 0.0;
    std::size_t terms = 0;  // number of orders n in each piece; fewer where the piece needs fewer
    // The field is U = sum_n beta_n row_n, row_n = sum_k C_nk x^k, with pupil coefficients beta_n, sum |beta_n|^2 / (2n+1) <= 1
    // (certificate, identity A). magnitude: bound on the sum of the moduli of all terms of U, which bounds the rounding of U:
    // maximum over pieces of sum_k sqrt(sum_n (2n+1) C_nk^2).
    double magnitude = 0.0;
    std::vector<std::shared_ptr<const Piece>> pieces;  // [index of the piece along v]; null if never requested
    std::size_t leading = 0;  // number of pieces before the first null

    bool has(std::size_t s) const { return s < pieces.size() && pieces[s] != nullptr; }
};

// Indices of the requested pieces: 0 .. leading - 1, and `others`, which are larger and ascending.
struct WantedPieces {
    std::size_t leading = 0;
    std::vector<std::size_t> others;
    std::size_t end() const { return others.empty() ? leading : others.back() + 1; }
};

class PieceTables final : Shared {
   public:
    // Return a table with at least the wanted pieces and `terms` rows. Missing pieces are computed once for all threads and
    // kept; all pieces are dropped when together they exceed `most_bytes`.
    std::shared_ptr<const PieceTable> get(std::size_t width_index, const WantedPieces& wanted, std::size_t terms) {
        if (auto found = held(width_index); serves(found.get(), wanted, terms)) {
            return found;
        }
        const Turn::Taken turn(turn_);
        const auto old = held(width_index);
        if (serves(old.get(), wanted, terms)) {
            return old;
        }
        const std::shared_ptr<const PieceTable> table = extended(old.get(), widths[width_index], wanted, terms);
        const Lock lock(mutex_);
        tables_[width_index] = table;
        if (bytes() > most_bytes) {
            tables_ = {};
        }
        return table;
    }

   private:
    static constexpr std::size_t most_bytes = std::size_t{128} << 20;
    using Tables = std::array<std::shared_ptr<const PieceTable>, widths.size()>;

    std::size_t kept() override {
        const Lock lock(mutex_);
        return bytes();
    }
    std::size_t limit() const override { return most_bytes; }
    void clear() override {
        Tables dropped;  // destroyed after the mutex is released
        const Lock lock(mutex_);
        tables_.swap(dropped);
    }

    std::shared_ptr<const PieceTable> held(std::size_t width_index) {
        const Lock lock(mutex_);
        return tables_[width_index];
    }

    static bool serves(const PieceTable* table, const WantedPieces& wanted, std::size_t terms) {
        return table != nullptr && table->terms >= terms && table->leading >= wanted.leading &&
               std::all_of(wanted.others.begin(), wanted.others.end(), [&](std::size_t s) { return table->has(s); });
    }

    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const auto& table : tables_) {
            for (std::size_t i = 0; table && i < table->pieces.size(); ++i) {
                sum += table->has(i) ? sizeof(double) * table->pieces[i]->rows.size() : 0;
            }
        }
        return sum;
    }

    std::shared_ptr<const PieceTable> extended(const PieceTable* old, double width, const WantedPieces& wanted,
                                               std::size_t terms) {
        auto table = std::make_shared<PieceTable>();
        table->width = width;
        // The number of rows (Bessel orders) is rounded up, so that slightly stronger defocus needs no new table.
        table->terms = (std::max(terms, old ? old->terms : 0) + 31) / 32 * 32;
        table->pieces.resize(std::max(wanted.end(), old ? old->pieces.size() : 0));
        const auto rows = [&](std::size_t s) { return std::min(table->terms, Piece::most(width, s)); };
        // Reuse the old table's pieces that have enough rows: all of them, unless the number of terms has grown.
        for (std::size_t s = 0; old && s < old->pieces.size(); ++s) {
            if (old->has(s) && (table->terms == old->terms || old->pieces[s]->terms() >= rows(s))) {
                table->pieces[s] = old->pieces[s];
            }
        }
        const auto need = [&](std::size_t s) {
            if (!table->pieces[s]) {
                look();
                table->pieces[s] = std::make_shared<const Piece>(made_piece(width, s, rows(s)));
            }
        };
        for (std::size_t s = 0; s < wanted.leading; ++s) {
            need(s);
        }
        for (const std::size_t s : wanted.others) {
            need(s);
        }
        while (table->has(table->leading)) {
            ++table->leading;
        }
        for (const auto& piece : table->pieces) {
            if (piece) {
                table->magnitude = std::max(table->magnitude, piece->magnitude);
            }
        }
        return table;
    }

    Tables tables_;
};

inline PieceTables& piece_tables = *new PieceTables;

// The 16 complex coefficients of the field U on one piece, in powers of x (-1 to 1 on the piece): sum over n < terms of the
// pupil coefficient beta_n times table row n. Speed is limited by reading the table, which is read once.
template <class I>
LOMMEL_INLINE void combine(I, const Piece& piece, std::size_t terms, const double* beta_re, const double* beta_im, double* re,
                           double* im) {
    using V = typename I::pack;
    constexpr std::size_t at_once = 2 * I::lanes < degree_count ? 2 * I::lanes : degree_count;
    constexpr std::size_t packs = at_once / I::lanes;
    terms = std::min(terms, piece.terms());
    for (std::size_t k = 0; k < degree_count; k += at_once) {
        const double* column = piece.rows.data() + k;
        V a[2][packs] = {}, b[2][packs] = {};  // two rows at once, so that their chains of multiply-adds overlap
        const auto add = [&](std::size_t j, std::size_t n) LOMMEL_INLINE_LAMBDA {
            for (std::size_t p = 0; p < packs; ++p) {
                const V c = load<V>(column + n * degree_count + p * I::lanes);
                a[j][p] = a[j][p] + c * splat<V>(beta_re[n]);
                b[j][p] = b[j][p] + c * splat<V>(beta_im[n]);
            }
        };
        std::size_t n = 0;
        for (; n + 2 <= terms; n += 2) {
            add(0, n);
            add(1, n + 1);
        }
        if (n < terms) {
            add(0, n);
        }
        for (std::size_t p = 0; p < packs; ++p) {
            store(re + k + p * I::lanes, a[0][p] + a[1][p]);
            store(im + k + p * I::lanes, b[0][p] + b[1][p]);
        }
    }
}

}  // namespace lommel
