#include "measures/strobe.hpp"

namespace pendula {

Outcome measure_section(const MeasureCall& call, const Control& control) noexcept {
    const Strobe& strobe = call.strobe;
    const double units = static_cast<double>(call.ensemble.size) * (strobe.transient + strobe.periods);
    return for_each_piece(chunks_of(call.ensemble.size), units, control, [&](Thread& thread, std::size_t chunk) {
        const Propagation run{strobe, thread, false};
        StrobedMembers m;
        load_strobed(m, call.ensemble, chunk * kernels::chunk_size);
        if (!integrate_to_first_strobe(m, run)) return;
        const auto& motion = m.chunk.motion;
        for (double n = 0; n < strobe.transient + strobe.periods; ++n) {
            if (n > 0 && !integrate_to_next_strobe(m, run)) return;
            thread.report(m.chunk.count);
            if (n < strobe.transient) continue;
            const auto row = static_cast<std::size_t>(n - strobe.transient);
            for (int i = 0; i < m.chunk.count; ++i) {
                call.result(0, row, m.number[i]) = motion.theta[i];
                call.result(1, row, m.number[i]) = motion.omega[i];
                call.result(2, row, m.number[i]) = motion.turns[i];
                call.result(3, row, m.number[i]) = __builtin_nan("");
            }
        }
    });
}

}  // namespace pendula
