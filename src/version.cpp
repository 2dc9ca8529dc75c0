#include "pendula/version.hpp"

#include "kernels/dispatch.hpp"

namespace pendula {

const char* instruction_set() noexcept { return kernels::is_choice_available() ? kernels::dispatch().name : nullptr; }

}  // namespace pendula
