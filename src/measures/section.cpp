#include "checks.hpp"
#include "measures/strobe.hpp"
#include "pendula/crossings.hpp"

namespace pendula {

namespace {

/// The section of one call, by the strobe or by a plane.
struct SectionCall {
    const MeasureCall& call;

    void put(std::size_t row, std::size_t member, const Sample& s) const noexcept {
        call.set(0, row, member, s.theta);
        call.set(1, row, member, s.omega);
        call.set(2, row, member, s.turns);
        call.set(3, row, member, s.t);
    }

    /// The state of place i of a chunk, which has come to strobe number n.
    static Sample state_at(const StrobedMembers& m, int i, double n) noexcept {
        const auto& motion = m.chunk.motion;
        const double turns = motion.turns[i] + 0 * motion.theta[i];  // NaN if the motion is lost
        return {time_of_strobe(m, i, n), motion.theta[i], motion.omega[i], turns};
    }

    void strobe_rows(StrobedMembers& m, const Propagation& run) const noexcept {
        for (double row = 0; row < call.strobe.periods; ++row) {
            if (row > 0 && !integrate_to_next_strobe(m, run)) return;
            for (int i = 0; i < m.chunk.count; ++i)
                put(static_cast<std::size_t>(row), m.number[i], state_at(m, i, call.strobe.transient + row));
            run.thread.report(m.chunk.count);
        }
    }

    Level level() const noexcept {
        const Strobe& s = call.strobe;
        return {s.plane == Plane::omega ? Crossed::omega : Crossed::theta, s.level, s.direction};
    }

    /// Finds the crossings of one member after the transient, at whose end it is. Returns how many were found.
    std::size_t crossings(const StrobedMembers& m, int i, Thread& thread) const noexcept {
        constexpr double steps_between_looks = 256;
        const auto start = state_at(m, i, call.strobe.transient);
        auto pendulum = pendulum_of(call.ensemble, m.number[i]);
        pendulum.drive_phase = m.chunk.parameters.drive_phase[i];
        const double until = call.strobe.budget * m.period[i];
        auto search = make_crossings(pendulum, {start.theta, start.omega}, level(), call.strobe.tolerance);
        Crossing next;
        std::size_t row = 0;
        while (row < rows() && thread.goes_on()) {
            const std::size_t end = row + 64 < rows() ? row + 64 : rows();  // a look after so many, too
            while (row < end && next_crossing(search, until, next, steps_between_looks)) {
                const Sample& s = next.sample;
                put(row++, m.number[i], {start.t + s.t, s.theta, s.omega, start.turns + s.turns});
            }
            if (row < end && reaches(search.run, until)) break;
        }
        return row;
    }

    void plane_rows(const StrobedMembers& m, Thread& thread) const noexcept {
        constexpr double nan = __builtin_nan("");
        for (int i = 0; i < m.chunk.count; ++i) {
            std::size_t row = m.chunk.is_resting[i] ? 0 : crossings(m, i, thread);
            for (; row < rows(); ++row) put(row, m.number[i], {nan, nan, nan, nan});
            thread.report(call.strobe.periods);
        }
    }

    std::size_t rows() const noexcept { return static_cast<std::size_t>(call.strobe.periods); }
};

Refusal check_plane(const Strobe& strobe) noexcept {
    using enum Refusal::Reason;
    if (!(strobe.plane >= Plane::strobe && strobe.plane <= Plane::omega))
        return {.reason = not_among, .name = "plane", .legal = "strobe, theta, omega"};
    if (!(strobe.direction >= Direction::both && strobe.direction <= Direction::falling))
        return {.reason = not_among, .name = "direction", .legal = "both, rising, falling"};
    if (strobe.plane != Plane::strobe && strobe.method != Method::taylor)  // crossings are found on its polynomials
        return {.reason = not_among, .name = "method", .legal = "taylor"};
    return {};
}

}  // namespace

Outcome measure_section(const MeasureCall& call, const Control& control) noexcept {
    const Strobe& strobe = call.strobe;
    if (const auto refusal = check_plane(strobe)) return refusal;
    const SectionCall section{call};
    const double units = static_cast<double>(call.ensemble.size) * (strobe.transient + strobe.periods);
    return for_each_piece(chunks_of(call.ensemble.size), units, control, [&](Thread& thread, std::size_t chunk) {
        const Propagation run{strobe, thread, false};
        StrobedMembers m;
        load_strobed(m, call.ensemble, chunk * kernels::chunk_size);
        if (strobe.plane == Plane::strobe && !integrate_to_first_strobe(m, run)) return;  // else the transient begins at t = 0
        for (double n = 0; n < strobe.transient; ++n) {
            if (!integrate_to_next_strobe(m, run)) return;
            thread.report(m.chunk.count);
        }
        if (strobe.plane == Plane::strobe)
            section.strobe_rows(m, run);
        else
            section.plane_rows(m, thread);
    });
}

}  // namespace pendula
