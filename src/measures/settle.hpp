// The driver of the measures that follow every motion until its kind is known.
#pragma once

#include "measures/fate.hpp"
#include "measures/strobe.hpp"

namespace pendula {

/// Receives the fates of members.
class PutFate {
  public:
    template <class Function>
    PutFate(const Function& function) noexcept
        : function_(&function),
          call_([](const void* f, std::size_t member, const Fate& fate) { (*static_cast<const Function*>(f))(member, fate); }) {
    }
    void operator()(std::size_t member, const Fate& fate) const noexcept { call_(function_, member, fate); }

  private:
    const void* function_;
    void (*call_)(const void*, std::size_t, const Fate&);
};

/// Finds the fate of every member. put(member, fate) is called once for each, from several threads. If `history` is not empty,
/// it receives the estimates of the exponent from growing parts of the measured periods [row][member], for the members whose
/// exponent is estimated.
Outcome settle(const Ensemble& ensemble, const Strobe& strobe, std::span<double> history, const Control& control,
               const PutFate& put) noexcept;

}  // namespace pendula
