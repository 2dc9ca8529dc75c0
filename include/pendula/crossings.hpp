// The times at which theta or omega crosses a level, from the polynomials of Taylor's method.
#pragma once

#include <concepts>
#include <span>
#include <type_traits>

#include "pendula/control.hpp"
#include "pendula/taylor.hpp"

namespace pendula {

/// The crossed quantity. Turning points are crossings of omega through 0.
enum class Crossed { theta, omega };
inline constexpr const char* crossed_names[] = {"theta", "omega"};

/// In which direction a level is crossed.
enum class Direction { both, rising, falling };
inline constexpr const char* direction_names[] = {"both", "rising", "falling"};

/// What a search looks for. Levels of theta are at + 2 pi m for every whole number m; omega has the one level `at`.
struct Level {
    constexpr Level(Crossed quantity, double value = 0, Direction way = Direction::both) noexcept
        : crossed(quantity), at(value), direction(way) {}

    Crossed crossed;
    double at;            ///< [rad] or [rad/s], finite; an angle is wrapped, as an initial angle is
    Direction direction;  ///< crossings in the other direction are left out
};

struct Crossing {
    Sample sample;
    bool is_rising = false;  ///< whether the crossed quantity increases there
};

/// The state of a search for crossings.
///
/// Each step of the trajectory is divided at the points where the derivative of the crossed quantity changes its sign. On each
/// part the quantity is monotone and crosses a level at most once, so that the signs at the ends of the parts count the
/// crossings. A step that cannot reach a level, by a bound on its polynomial, is not divided. A step's last value and the next
/// step's first value have the same bits: no crossing is missed or found twice, and at one level rising and falling crossings
/// alternate. Where the quantity approaches a level to within its rounding error, about 1e-16, rounding decides whether there
/// are two crossings or none. A motion that touches a level and turns back does not cross it, nor does a motion that starts on
/// it. A pendulum that rests at the top (`rests_on_top`) crosses nothing.
struct Crossings {
    Taylor run;
    Level level{Crossed::theta};
    double at = 0;         ///< the level; of theta, in [-pi, pi)
    double turns = 0;      ///< of the start; levels of theta are counted from there
    double side = 0;       ///< 2 m + 1 between the levels m and m + 1; 2 m while still on the level m of the start
    double cuts[27] = {};  ///< the ends of the parts of the step, in seconds from its start
    int cut_count = 0;
    int cut = 0;           ///< index of the part that is searched next
    bool is_upon = false;  ///< the last value was exactly on a level, first reached at `upon`
    Sample upon;
};

/// Starts a search along the trajectory that begins at time t [s]. The other arguments are those of `make_taylor`, with the
/// same intervals; an argument outside its interval gives a search without crossings.
Crossings make_crossings(const Pendulum& pendulum, State initial, const Level& level, double tolerance = 1e-15,
                         double t = 0) noexcept;

/// Finds the next crossing up to time `until` [s] and returns true. The error of its time is about the rounding error of the
/// crossed quantity and of the level, divided by the rate of change (tests/cpp/crossings_test.cpp). Returns false if there is
/// no such crossing, if the motion is not finite, if it would take more than 2^53 steps, or after about `step_budget` steps.
/// The search is complete if `reaches(search.run, until)` then holds; otherwise the call may be repeated. The bits do not
/// depend on how the search is divided into calls.
bool next_crossing(Crossings& search, double until, Crossing& crossing, double step_budget = 0x1p53) noexcept;

/// What to search for in each member of an ensemble.
struct EnsembleLevels {
    Crossed crossed = Crossed::theta;
    Column at = 0.0;  ///< see `Level`
    Direction direction = Direction::both;
    Column until = 1.0;  ///< the time up to which is searched [s], >= 0
};

/// A callback that receives crossings. Its arguments are the number of the member and the crossing; it returns whether the call
/// is to continue. It is a plain function, or a lambda whose captures take at most 32 bytes, and is stored by value. Several
/// threads call it at once, but for one member always the same thread.
class Receive {
    static constexpr std::size_t room = 32;

  public:
    template <std::invocable<std::size_t, const Crossing&> Function>
        requires(std::is_trivially_copyable_v<Function> && sizeof(Function) <= room)
    Receive(Function function) noexcept {
        __builtin_memcpy(function_, &function, sizeof function);
        call_ = [](const void* f, std::size_t member, const Crossing& crossing) {
            return static_cast<bool>((*static_cast<const Function*>(f))(member, crossing));
        };
    }
    bool operator()(std::size_t member, const Crossing& crossing) const { return call_(function_, member, crossing); }

  private:
    alignas(double) unsigned char function_[room] = {};
    bool (*call_)(const void*, std::size_t, const Crossing&) = nullptr;
};

/// Finds the crossings of every member from t = 0 up to its time `until`, and hands them over in the order of time for each
/// member. They are those of `next_crossing`. A motion that leaves the range of doubles ends with a crossing whose values are
/// NaN. Refused where a member, a level, a time, the tolerance or the length of a column is not legal.
Outcome find_crossings(const Ensemble& ensemble, const EnsembleLevels& levels, double tolerance, const Receive& receive,
                       const Control& control = {}) noexcept;

/// Computes the period [s]: the mean time between crossings of theta through multiples of 2 pi in the direction of the first,
/// up to time `until` [s]. That is the period of an oscillation or a rotation; where the motion repeats only after several
/// crossings, it is the mean over them. The error is that of two crossing times, divided by the number of periods. NaN if there
/// are fewer than two such crossings, or if the motion leaves the range of doubles. Refused where an argument is outside its
/// interval: until >= 0 and finite, tolerance in (0, 1).
Outcome measured_period(const Pendulum& pendulum, State initial, double until, double tolerance, double& period,
                        const Control& control = {}) noexcept;

/// The same for every member of an ensemble. Refused also if `periods`
/// holds fewer values than there are members, or a column has the wrong length.
Outcome measured_period(const Ensemble& ensemble, const Column& until, double tolerance, std::span<double> periods,
                        const Control& control = {}) noexcept;

}  // namespace pendula
