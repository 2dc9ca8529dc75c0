// How a long call is run, and how it ends.
#pragma once

#include <concepts>
#include <type_traits>

#include "pendula/parameters.hpp"

namespace pendula {

/// How a call ended.
struct [[nodiscard]] Outcome {
    enum class Kind {
        done,
        stopped,  ///< by the caller's `proceed`; results are not complete
        refused,  ///< nothing was done; `refusal` says why
    };
    Kind kind = Kind::done;
    Refusal refusal{};

    constexpr Outcome() noexcept = default;
    constexpr Outcome(Kind how) noexcept : kind(how) {}
    constexpr Outcome(const Refusal& why) noexcept : kind(why ? Kind::refused : Kind::done), refusal(why) {}
    constexpr bool is_done() const noexcept { return kind == Kind::done; }
};

/// A function of the fraction done, in [0, 1], that returns whether to go on: a lambda that captures at most 32 bytes (four
/// references), or a plain function. It is kept by value, and called some hundred times a second by the thread that made the call.
class Proceed {
    static constexpr std::size_t room = 32;

  public:
    constexpr Proceed() noexcept = default;
    template <std::invocable<double> Function>
        requires(std::is_trivially_copyable_v<Function> && sizeof(Function) <= room)
    Proceed(Function function) noexcept {
        __builtin_memcpy(function_, &function, sizeof function);
        call_ = [](const void* f, double done) { return static_cast<bool>((*static_cast<const Function*>(f))(done)); };
    }
    bool operator()(double done) const { return !call_ || call_(function_, done); }

  private:
    alignas(double) unsigned char function_[room] = {};
    bool (*call_)(const void*, double) = nullptr;
};

/// The most threads that a call takes.
inline constexpr int threads_limit = 256;

/// How a long call is run.
struct Control {
    int threads = 0;    ///< at most so many, up to threads_limit; 0: as many as there are processors
    Proceed proceed{};  ///< tells the progress, and may stop the call
};

}  // namespace pendula
