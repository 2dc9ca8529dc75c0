// Made by tools/make_coefficients.py, which states the command; do not edit.
#pragma once

namespace pendula::arithmetic {

// pi/2 in 33 + 33 + 33 + 53 bits: products by a whole number below 2^20 are exact.
inline constexpr double pi_over_2_parts[4] = {
    0x1.921fb54400000p+0,
    0x1.0b4611a600000p-34,
    0x1.3198a2e000000p-69,
    0x1.b839a252049c1p-104,
};

// 2/pi.
inline constexpr double two_over_pi[1] = {
    0x1.45f306dc9c883p-1,
};

// pi in two doubles.
inline constexpr double pi_dd[2] = {
    0x1.921fb54442d18p+1,
    0x1.1a62633145c07p-53,
};

// two_pi in two doubles.
inline constexpr double two_pi_dd[2] = {
    0x1.921fb54442d18p+2,
    0x1.1a62633145c07p-52,
};

// pi_over_2 in two doubles.
inline constexpr double pi_over_2_dd[2] = {
    0x1.921fb54442d18p+0,
    0x1.1a62633145c07p-54,
};

// pi_over_180 in two doubles.
inline constexpr double pi_over_180_dd[2] = {
    0x1.1df46a2529d39p-6,
    0x1.5c1d8becdd291p-62,
};

// ln2 in two doubles.
inline constexpr double ln2_dd[2] = {
    0x1.62e42fefa39efp-1,
    0x1.abc9e3b39803fp-56,
};

// inverse_two_pi in two doubles.
inline constexpr double inverse_two_pi_dd[2] = {
    0x1.45f306dc9c883p-3,
    -0x1.6b01ec5417056p-57,
};

// 2 pi in 26 + 26 + 53 + 53 bits: products by a whole number of up to 27 bits are exact in the first two.
inline constexpr double two_pi_parts[4] = {
    0x1.921fb50000000p+2,
    0x1.110b460000000p-24,
    0x1.1a62633145c06p-52,
    0x1.c1cd129024e09p-105,
};

// ln 2 in 32 + 53 bits: products by a binary exponent are exact in the first.
inline constexpr double ln2_parts[2] = {
    0x1.62e42fee00000p-1,
    0x1.a39ef35793c76p-33,
};

// 1/ln 2.
inline constexpr double inverse_ln2[1] = {
    0x1.71547652b82fep+0,
};

// sine of 0.999 pi/2, half the angle at which the time on the separatrix ends (3.5), in two doubles.
inline constexpr double mark_sine_dd[2] = {
    0x1.ffffd69a985b9p-1,
    0x1.7701362f5c63bp-57,
};

// cosine of 0.999 pi/2, half the angle at which the time on the separatrix ends (3.5), in two doubles.
inline constexpr double mark_cosine_dd[2] = {
    0x1.9bc6504fbc485p-10,
    0x1.efbad94b9a976p-64,
};

// (sin x - x)/x^3 in x^2, |x| <= pi/4, relative to sin x: largest error 1.8e-17 = 2^-55.6.
inline constexpr double sin_quarter[6] = {
    -0x1.5555555555555p-3,
    0x1.1111111110bb1p-7,
    -0x1.a01a019e8357dp-13,
    0x1.71de37961e4c6p-19,
    -0x1.ae600a926c89ap-26,
    0x1.5e0af186af739p-33,
};

// (cos x - 1 + x^2/2)/x^4 in x^2, |x| <= pi/4, absolute: largest error 7.8e-19 = 2^-60.1.
inline constexpr double cos_quarter[6] = {
    0x1.5555555555555p-5,
    -0x1.6c16c16c16966p-10,
    0x1.a01a019f4e867p-16,
    -0x1.27e4fa17a41b4p-22,
    0x1.1eeb68b109173p-29,
    -0x1.907d7aebd5e3dp-37,
};

// (sin x - x)/x^3 in x^2, |x| <= 1/48, relative to sin x: largest error 2.0e-15 = 2^-48.8.
inline constexpr double sin_short[2] = {
    -0x1.555555552c3cbp-3,
    0x1.1110582233d3dp-7,
};

// (cos x - 1 + x^2/2)/x^4 in x^2, |x| <= 1/48, absolute: largest error 1.1e-19 = 2^-63.0.
inline constexpr double cos_short[2] = {
    0x1.5555555540c90p-5,
    -0x1.6c16087d2cbb1p-10,
};

// sin(pi f)/f in f^2, |f| <= 1/4, relative to sin(pi f): largest error 3.8e-17 = 2^-54.5.
inline constexpr double sin_turn[7] = {
    0x1.921fb54442d18p+1,
    -0x1.4abbce625be41p+2,
    0x1.466bc677587f3p+1,
    -0x1.32d2cce2e55bfp-1,
    0x1.50782fd9b7104p-4,
    -0x1.e300715607854p-8,
    0x1.e3f362f896ffep-12,
};

// (cos(pi f) - 1)/f^2 in f^2, |f| <= 1/4, absolute: largest error 1.8e-17 = 2^-55.6.
inline constexpr double cos_turn[7] = {
    -0x1.3bd3cc9be45dep+2,
    0x1.03c1f081b5ac0p+2,
    -0x1.55d3c7e3cb23fp+0,
    0x1.e1f5068688925p-3,
    -0x1.a6d1eef43193ep-6,
    0x1.f9ce24161feb0p-10,
    -0x1.b2f3d15e072b2p-14,
};

// (exp x - 1 - x)/x^2, |x| <= ln(2)/2, relative to exp x: largest error 3.4e-19 = 2^-61.4.
inline constexpr double exp_remainder[11] = {
    0x1.0000000000000p-1,
    0x1.5555555555557p-3,
    0x1.5555555555556p-5,
    0x1.11111111100dcp-7,
    0x1.6c16c16c162d4p-10,
    0x1.a01a01abe7fe1p-13,
    0x1.a01a01a6d889cp-16,
    0x1.71de0231960ebp-19,
    0x1.27e4db646b17ep-22,
    0x1.af4de97ca4194p-26,
    0x1.1f730349868cep-29,
};

// (log((1 + s)/(1 - s)) - 2 s)/s^3 in s^2, s <= (sqrt 2 - 1)/(sqrt 2 + 1), relative to the logarithm: largest error 4.3e-18 = 2^-57.7.
inline constexpr double log_remainder[7] = {
    0x1.5555555555558p-1,
    0x1.99999999952d7p-2,
    0x1.2492492df281ap-2,
    0x1.c71c62e3f11e6p-3,
    0x1.7462b51cb66b1p-3,
    0x1.39fe51a7c18f9p-3,
    0x1.2b5900de53b32p-3,
};

// (atan x - x)/x^3 in x^2, |x| <= tan(pi/8), relative to atan x: largest error 6.7e-18 = 2^-57.0.
inline constexpr double atan_remainder[11] = {
    -0x1.5555555555555p-2,
    0x1.999999999934ap-3,
    -0x1.24924924360cbp-3,
    0x1.c71c7185314cbp-4,
    -0x1.745d0b26b83e7p-4,
    0x1.3b1262d95579ep-4,
    -0x1.10fa75382537fp-4,
    0x1.dfe61e80903d2p-5,
    -0x1.a098bb6ba4941p-5,
    0x1.41603647c7a7cp-5,
    -0x1.3a2b7a07caea9p-6,
};

// 1/n! for n = 2, 3, …: leading doubles.
inline constexpr double inverse_factorial_hi[28] = {
    0x1.0000000000000p-1,
    0x1.5555555555555p-3,
    0x1.5555555555555p-5,
    0x1.1111111111111p-7,
    0x1.6c16c16c16c17p-10,
    0x1.a01a01a01a01ap-13,
    0x1.a01a01a01a01ap-16,
    0x1.71de3a556c734p-19,
    0x1.27e4fb7789f5cp-22,
    0x1.ae64567f544e4p-26,
    0x1.1eed8eff8d898p-29,
    0x1.6124613a86d09p-33,
    0x1.93974a8c07c9dp-37,
    0x1.ae7f3e733b81fp-41,
    0x1.ae7f3e733b81fp-45,
    0x1.952c77030ad4ap-49,
    0x1.6827863b97d97p-53,
    0x1.2f49b46814157p-57,
    0x1.e542ba4020225p-62,
    0x1.71b8ef6dcf572p-66,
    0x1.0ce396db7f853p-70,
    0x1.761b41316381ap-75,
    0x1.f2cf01972f578p-80,
    0x1.3f3ccdd165fa9p-84,
    0x1.88e85fc6a4e5ap-89,
    0x1.d1ab1c2dccea3p-94,
    0x1.0a18a2635085dp-98,
    0x1.259f98b4358adp-103,
};

// 1/n!: the remainders.
inline constexpr double inverse_factorial_lo[28] = {
    0x0.0p+0,
    0x1.5555555555555p-57,
    0x1.5555555555555p-59,
    0x1.1111111111111p-63,
    -0x1.f49f49f49f49fp-65,
    0x1.a01a01a01a01ap-73,
    0x1.a01a01a01a01ap-76,
    -0x1.c154f8ddc6c00p-73,
    0x1.cbbc05b4fa99ap-76,
    -0x1.c062e06d1f209p-80,
    -0x1.2aec959e14c06p-83,
    0x1.f28e0cc748ebep-87,
    0x1.05d6f8a2efd1fp-92,
    0x1.1d8656b0ee8cbp-97,
    0x1.1d8656b0ee8cbp-101,
    0x1.ac981465ddc6cp-103,
    0x1.eec01221a8b0bp-107,
    0x1.2650f61dbdcb4p-112,
    0x1.ea72b4afe3c2fp-120,
    -0x1.d043ae40c4647p-120,
    -0x1.aebcdbd20331cp-124,
    -0x1.3423c7d91404fp-130,
    -0x1.9ada5fcc1ab14p-135,
    -0x1.58ddadf344487p-139,
    -0x1.71c37ebd16540p-143,
    0x1.054d0c78aea14p-149,
    0x1.b9e2e28e1aa54p-153,
    0x1.eaf8c39dd9bc5p-157,
};

// 2/pi after the binary point, 32 bits a word: enough for the largest double and 100 bits beyond.
inline constexpr unsigned two_over_pi_words[40] = {
    0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu, 0xdebbc561u,
    0xb7246e3au, 0x424dd2e0u, 0x06492eeau, 0x09d1921cu, 0xfe1deb1cu, 0xb129a73eu, 0xe88235f5u, 0x2ebb4484u,
    0xe99c7026u, 0xb45f7e41u, 0x3991d639u, 0x835339f4u, 0x9c845f8bu, 0xbdf9283bu, 0x1ff897ffu, 0xde05980fu,
    0xef2f118bu, 0x5a0a6d1fu, 0x6d367ecfu, 0x27cb09b7u, 0x4f463f66u, 0x9e5fea2du, 0x7527bac7u, 0xebe5f17bu,
    0x3d0739f7u, 0x8a5292eau, 0x6bfb5fb1u, 0x1f8d5d08u, 0x56033046u, 0xfc7b6babu, 0xf0cfbc20u, 0x9af4361du,
};

}  // namespace pendula::arithmetic
