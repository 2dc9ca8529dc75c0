#include "arithmetic/reduce_huge.hpp"

#include <cstdint>

#include "arithmetic/coefficients.hpp"
#include "arithmetic/double_double.hpp"

namespace pendula::arithmetic {
namespace {

constexpr int words = 6;  // a window of 192 bits

/// 32 bits of 2/pi: those after the first `from` bits behind the binary point. Bits before the binary point are 0.
std::uint32_t bits_of_two_over_pi(int from) noexcept {
    const auto word = [](int i) -> std::uint64_t { return i < 0 ? 0 : two_over_pi_words[i]; };
    const int index = from >> 5, shift = from & 31;  // also of negative numbers
    return static_cast<std::uint32_t>(((word(index) << 32 | word(index + 1)) << shift) >> 32);
}

}  // namespace

HugeReduction reduce_huge(double x) noexcept {
    if (!(abs(x) < __builtin_inf())) return {x - x, x - x, 0};
    // |x| = m 2^e. The bits of 2/pi with weight 2^-j, j <= e - 2, contribute multiples of 4 to x 2/pi and are left out. So x
    // 2/pi mod 4 = m w 2^-190 mod 4, where w is the window of 192 bits behind them.
    const std::int64_t representation = bits(x);
    const int e = static_cast<int>(representation >> 52 & 0x7ff) - 1075;
    const std::uint64_t m = (static_cast<std::uint64_t>(representation) & 0xfffffffffffff) | 0x10000000000000;
    const std::uint64_t m_parts[2] = {m & 0xffffffff, m >> 32};

    std::uint32_t product[words] = {};  // least significant first
    for (int part = 0; part < 2; ++part) {
        std::uint64_t carry = 0;
        for (int i = part; i < words; ++i) {
            const std::uint64_t window_word = bits_of_two_over_pi(e - 2 + 32 * (words - 1 - (i - part)));
            const std::uint64_t sum = product[i] + m_parts[part] * window_word + carry;
            product[i] = static_cast<std::uint32_t>(sum);
            carry = sum >> 32;
        }
    }

    int quadrant = static_cast<int>(product[words - 1] >> 30);
    product[words - 1] &= 0x3fffffff;
    const bool is_upper_half = product[words - 1] >> 29;
    quadrant += is_upper_half;

    DoubleDouble<double> fraction{is_upper_half ? -1.0 : 0.0, 0.0};
    double weight = 0x1p-30;
    for (int i = words - 1; i >= 0; --i, weight *= 0x1p-32) fraction = fraction + product[i] * weight;
    auto angle = fraction * DoubleDouble<double>{pi_over_2_dd[0], pi_over_2_dd[1]};
    if (x < 0) {
        angle = -angle;
        quadrant = -quadrant;
    }
    return {angle.hi, angle.lo, quadrant & 3};
}

}  // namespace pendula::arithmetic
