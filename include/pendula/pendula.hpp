// Includes all public headers of pendula.
#pragma once

#include "pendula/actividad3.hpp"
#include "pendula/analysis.hpp"
#include "pendula/angle.hpp"
#include "pendula/control.hpp"
#include "pendula/crossings.hpp"
#include "pendula/ensemble.hpp"
#include "pendula/exact.hpp"
#include "pendula/measure.hpp"
#include "pendula/parameters.hpp"
#include "pendula/pendulum.hpp"
#include "pendula/schedule.hpp"
#include "pendula/solve.hpp"
#include "pendula/steps.hpp"
#include "pendula/taylor.hpp"
#include "pendula/validate.hpp"
#include "pendula/version.hpp"
