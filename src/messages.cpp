#include "src/messages.hpp"

#include <cstdlib>

namespace pendula {

Language language_of(std::span<const std::string_view> arguments) {
    constexpr std::string_view option = "--lang";
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        std::string_view value = i + 1 < arguments.size() && arguments[i] == option ? arguments[i + 1] : "";
        if (arguments[i].starts_with("--lang=")) value = arguments[i].substr(option.size() + 1);
        if (value == "es") return Language::es;
        if (value == "en") return Language::en;
    }
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (const char* value = std::getenv(name); value && *value)
            return std::string_view(value).starts_with("es") ? Language::es : Language::en;
    return Language::en;
}

}  // namespace pendula
