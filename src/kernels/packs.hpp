// Loads packs of consecutive members from a chunk, and stores them.
#pragma once

#include "arithmetic/pack.hpp"
#include "kernels/chunk.hpp"

namespace pendula::kernels::inline PENDULA_ISA {

using namespace arithmetic;

/// The values of the members i, i + 1, ..., one for each lane of T.
template <class T>
inline T load(const Row& from, int i) {
    T pack;
    __builtin_memcpy(&pack, from + i, sizeof pack);
    return pack;
}

template <class T>
inline void store(Row& to, int i, const T& pack) {
    __builtin_memcpy(to + i, &pack, sizeof pack);
}

/// The same for a struct whose members are all of type Row: `load<T, Motion>(chunk.motion, i)`.
template <class T, template <class> class Struct>
inline Struct<T> load(const Struct<Row>& from, int i) {
    static_assert(sizeof(Struct<T>) / sizeof(T) == sizeof from / sizeof(Row));
    Struct<T> to;
    for (unsigned k = 0; k < sizeof to / sizeof(T); ++k)
        __builtin_memcpy(reinterpret_cast<char*>(&to) + k * sizeof(T),
                         reinterpret_cast<const char*>(&from) + k * sizeof(Row) + i * sizeof(double), sizeof(T));
    return to;
}

template <class T, template <class> class Struct>
inline void store(Struct<Row>& to, int i, const Struct<T>& from) {
    for (unsigned k = 0; k < sizeof from / sizeof(T); ++k)
        __builtin_memcpy(reinterpret_cast<char*>(&to) + k * sizeof(Row) + i * sizeof(double),
                         reinterpret_cast<const char*>(&from) + k * sizeof(T), sizeof(T));
}

}  // namespace pendula::kernels::inline PENDULA_ISA
