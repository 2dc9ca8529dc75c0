#include "pendula/measure.hpp"

#include "pendula/angle.hpp"
#include "strobe.hpp"

namespace pendula {

bool section(const Ensemble& ensemble, const Strobe& strobe, const Control& control, const EnsembleRows& rows) noexcept {
    return for_each_chunk(ensemble, strobe, control, [&](Progress& progress, std::size_t first, bool is_caller) {
        const Way way{strobe, progress, is_caller, false};
        Strobed m;
        load(m, ensemble, first);
        if (!go_to_first_strobe(m, way) || !go_through_transient(m, way)) return;
        for (std::size_t row = 0; static_cast<double>(row) < strobe.periods; ++row) {
            if (row > 0 && !go_to_next_strobe(m, way)) return;
            for (int i = 0; i < m.chunk.count; ++i) {
                const std::size_t at = row * ensemble.size + first + static_cast<std::size_t>(i);
                rows.theta[at] = m.chunk.theta[i];
                rows.omega[at] = m.chunk.omega[i];
                rows.turns[at] = m.chunk.turns[i];
            }
        }
    });
}

bool mean_velocity(const Ensemble& ensemble, const Strobe& strobe, const Control& control, double* velocity) noexcept {
    return for_each_chunk(ensemble, strobe, control, [&](Progress& progress, std::size_t first, bool is_caller) {
        const Way way{strobe, progress, is_caller, false};
        Strobed m;
        load(m, ensemble, first);
        if (!go_to_first_strobe(m, way) || !go_through_transient(m, way)) return;
        const kernels::Chunk start = m.chunk;
        for (double done = 0; done < strobe.periods; ++done)
            if (!go_to_next_strobe(m, way)) return;
        for (int i = 0; i < m.chunk.count; ++i) {
            const double turned = (m.chunk.turns[i] - start.turns[i]) + (m.chunk.theta[i] - start.theta[i]) / (2 * pi);
            velocity[first + static_cast<std::size_t>(i)] = turned / strobe.periods * m.frequency[i];
        }
    });
}

}  // namespace pendula
