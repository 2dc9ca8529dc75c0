#include "pendula/validate.hpp"

#include <charconv>
#include <limits>
#include <stdexcept>
#include <vector>

namespace pendula {

namespace {

constexpr Words legal_of(Rule rule) {
    switch (rule) {
        case Rule::finite:
            return {"finite", "un número finito"};
        case Rule::positive:
            return {"positive and finite", "un número finito mayor que 0"};
        case Rule::not_negative:
            return {"finite and not negative", "un número finito no menor que 0"};
        case Rule::fraction:
            return {"between 0 and 1, both excluded", "un número entre 0 y 1, ambos excluidos"};
    }
    return {"", ""};
}

std::string shortest(double value) {
    if (value >= 0x1p53 && value < 0x1p54) return "2^53";
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

/// Places of the pattern: {n} name, {v} value, {l} least, {m} most, {w} legal words, {r} the interval of the rule.
Words pattern_of(Refusal::Reason reason) {
    using enum Refusal::Reason;
    switch (reason) {
        case none:
            break;
        case interval:
            return {"{n} must be {r}, got {v}", "{n} debe ser {r}, y es {v}"};
        case needs_frequency:
            return {"a drive or a shaken pivot needs a frequency: {n} must be {r}, got {v}",
                    "un forzamiento o un pivote agitado necesita una frecuencia: {n} debe ser {r}, y es {v}"};
        case whole:
            return {"{n} must be a whole number from {l} to {m}, got {v}", "{n} debe ser un entero de {l} a {m}, y es {v}"};
        case length:
            return {"{n} must have {l} values, got {v}", "{n} debe tener {l} valores, y tiene {v}"};
        case decreasing:
            return {"{n} must not decrease, got {v} after {l}", "{n} no debe decrecer, y es {v} después de {l}"};
        case not_among:
            return {"{n} must be one of {w}", "{n} debe ser uno de {w}"};
        case not_conservative:
            return {"method {n} needs a pendulum without friction, torque, drive and shaken pivot",
                    "el método {n} necesita un péndulo sin rozamiento, par, forzamiento ni pivote agitado"};
        case has_friction:
            return {"method {n} needs a pendulum without friction", "el método {n} necesita un péndulo sin rozamiento"};
        case unstable:
            return {"{n} must be at least {l}, or the method is unstable, got {v}; or use method taylor",
                    "{n} debe ser al menos {l}, o el método es inestable, y es {v}; o usa el método taylor"};
        case too_many_rows:
            return {
                "there would be {v} rows, more than 2^53 = 9007199254740992; leave more time between them or make the run "
                "shorter",
                "habría {v} filas, más de 2^53 = 9007199254740992; deja más tiempo entre ellas o acorta la simulación"};
        case too_many_steps:
            return {"it would take {v} steps, more than 2^53 = 9007199254740992; make them longer or the run shorter",
                    "daría {v} pasos, más de 2^53 = 9007199254740992; alárgalos o acorta la simulación"};
        case too_many_terms:
            return {"the series needs {v} terms, more than {m}", "la serie necesita {v} términos, más de {m}"};
        case too_late:
            return {"the closed form is right up to t = {m} s, not at {v} s",
                    "la solución exacta es correcta hasta t = {m} s, no en {v} s"};
        case instruction_set:
            return {"PENDULA_ISA must be one of the instruction sets of this processor (baseline, avx2, avx512), or not be set",
                    "PENDULA_ISA debe ser uno de los juegos de instrucciones de este procesador (baseline, avx2, avx512), o no "
                    "estar"};
        case memory:
            return {"there is not enough memory", "no hay memoria suficiente"};
    }
    return {"", ""};
}

}  // namespace

std::string describe(const Refusal& refusal, Language language, const std::string& name) {
    const auto say = [language](const Words& words) { return std::string(language == Language::es ? words.es : words.en); };
    const std::string pattern = say(pattern_of(refusal.reason));
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '{') {
            text += pattern[i];
            continue;
        }
        const char place = pattern[i + 1];
        text += place == 'n'   ? (name.empty() ? refusal.name : name)
                : place == 'v' ? shortest(refusal.value)
                : place == 'l' ? shortest(refusal.least)
                : place == 'm' ? shortest(refusal.most)
                : place == 'w' ? refusal.legal
                               : say(legal_of(refusal.rule));
        i += 2;
    }
    if (refusal.row != Refusal::no_member) text += say({" at index ", " en el índice "}) + std::to_string(refusal.row);
    if (refusal.member != Refusal::no_member) text += say({" (member ", " (miembro "}) + std::to_string(refusal.member) + ')';
    return text;
}

void require(const Refusal& refusal) {
    if (refusal) throw std::invalid_argument(describe(refusal));
}

bool require(const Outcome& outcome) {
    require(outcome.refusal);
    return outcome.is_done();
}

std::vector<Sample> solve(const Problem& problem) {
    Trajectory run = begin(problem);
    require(run.refusal);
    if (problem.schedule.rows > static_cast<double>(std::numeric_limits<std::ptrdiff_t>::max()) / sizeof(Sample))
        throw std::bad_alloc();
    std::vector<Sample> rows(static_cast<std::size_t>(problem.schedule.rows));
    constexpr double no_limit = std::numeric_limits<double>::infinity();
    for (std::size_t done = 0; done < rows.size();) done += advance(run, std::span(rows).subspan(done), no_limit);
    return rows;
}

}  // namespace pendula
