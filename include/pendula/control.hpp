// Control of a long call: number of threads, progress, cancellation; and how a call ended.
#pragma once

#include <concepts>
#include <type_traits>

#include "pendula/parameters.hpp"

namespace pendula {

/// How a call ended.
struct [[nodiscard]] Outcome {
    enum class Kind {
        done,
        stopped,  ///< the caller's `proceed` returned false; the results are incomplete
        refused,  ///< nothing was computed; `refusal` gives the reason
    };
    Kind kind = Kind::done;
    Refusal refusal{};

    constexpr Outcome() noexcept = default;
    constexpr Outcome(Kind how) noexcept : kind(how) {}
    constexpr Outcome(const Refusal& why) noexcept : kind(why ? Kind::refused : Kind::done), refusal(why) {}
    constexpr bool is_done() const noexcept { return kind == Kind::done; }
};

/// A callback for progress and cancellation. Its argument is the fraction of the work that is done, in [0, 1]; it returns
/// whether the call is to continue. It is a plain function, or a lambda whose captures take at most 32 bytes (four references),
/// and is stored by value. Only the thread that made the call calls it, some hundred to some thousand times a second.
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

/// The largest number of threads of a call.
inline constexpr int threads_limit = 256;

/// The settings of a long call.
struct Control {
    int threads = 0;    ///< the largest number of threads, up to threads_limit; 0: one for each processor
    Proceed proceed{};  ///< called with the progress; stops the call by returning false
};

}  // namespace pendula
