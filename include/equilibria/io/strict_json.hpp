/// \file
/// JSON from outside, read strictly: each value knows its place in the text, and what is wrong is refused by an
/// InvalidArgument that names the place, quotes the value and says what is allowed, as in
///
///     elements[3].nodes[1] = "B7": must be the name of a node
///
/// Beyond what JSON forbids, keys that nobody asks for are errors, so that a misspelt one is not lost, and so are keys
/// that appear twice in an object. Needs nlohmann/json.
#pragma once

#if !__has_include(<nlohmann/json.hpp>)
#error "reading JSON needs <nlohmann/json.hpp>: Debian's package nlohmann-json3-dev, or github.com/nlohmann/json"
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <equilibria/core/error.hpp>

namespace equilibria::detail {

using Json = nlohmann::json;

/// An error that names its place in the text.
class JsonError : public InvalidArgument {
public:
    using InvalidArgument::InvalidArgument;
};

/// A value as JSON, the rest cut off where it is long.
inline std::string in_short(const Json& value) {
    constexpr std::size_t most = 60;
    std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() <= most) return text;
    std::size_t end = most;
    while ((static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // within a character of UTF-8
    return text.substr(0, end) + "...";
}

/// The place of a member of the object at `place`.
inline std::string member_place(const std::string& place, const std::string& key) {
    const auto plain = [](unsigned char c) {
        return c == '_' || ('0' <= c && c <= '9') || ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z');
    };
    if (key.empty() || key.size() > 40 || !std::all_of(key.begin(), key.end(), plain))
        return place + "[" + in_short(key) + "]";
    return place.empty() ? key : place + "." + key;
}
inline std::string item_place(const std::string& place, std::size_t k) { return place + "[" + std::to_string(k) + "]"; }

/// A value and its place.
class JsonPlace {
public:
    JsonPlace(const Json& value, std::string place) : value_(&value), place_(std::move(place)) {}

    [[noreturn]] void refuse(const std::string& allowed) const {
        throw JsonError(place_.empty() ? "JSON text" : place_, in_short(*value_), allowed);
    }

    const Json& json() const { return *value_; }
    const std::string& name() const { return place_; }
    const std::string& string() const {
        if (!value_->is_string()) refuse("must be a string");
        return value_->get_ref<const std::string&>();
    }
    bool boolean() const {
        if (!value_->is_boolean()) refuse("must be true or false");
        return value_->get<bool>();
    }
    double number() const {
        if (!value_->is_number()) refuse("must be a number");
        return value_->get<double>();
    }
    double positive() const {
        if (!value_->is_number() || !(number() > 0)) refuse("must be a positive number");
        return number();
    }
    int integer(int least, int most) const {
        if (!value_->is_number_integer() || number() < least || number() > most)
            refuse("must be an integer from " + std::to_string(least) + " to " + std::to_string(most));
        return value_->get<int>();
    }
    Eigen::Vector3d vector() const {
        if (!value_->is_array() || value_->size() != 3) refuse("must be a list of 3 numbers");
        return {(*this)[0].number(), (*this)[1].number(), (*this)[2].number()};
    }
    /// The unit vector along a vector.
    Eigen::Vector3d direction() const {
        const Eigen::Vector3d y = vector();
        if (!(y.stableNorm() > 0 && std::isfinite(y.stableNorm()))) refuse("must have a positive and finite length");
        return y.stableNormalized();
    }
    /// Which one of these words it is.
    std::size_t choice(std::initializer_list<std::string_view> words) const {
        std::size_t k = 0;
        std::string allowed;
        for (const auto word : words) {
            if (value_->is_string() && word == value_->get_ref<const std::string&>()) return k;
            ++k;
            allowed += (k == 1 ? "\"" : k == words.size() ? " or \"" : ", \"") + std::string(word) + "\"";
        }
        refuse("must be " + allowed);
    }

    /// The number of values in a list.
    std::size_t size() const {
        if (!value_->is_array()) refuse("must be a list");
        return value_->size();
    }
    JsonPlace operator[](std::size_t k) const { return {(*value_)[k], item_place(place_, k)}; }

    const Json& object() const {
        if (!value_->is_object()) refuse("must be an object");
        return *value_;
    }
    /// A member of an object.
    JsonPlace at(const std::string& key) const {
        const auto found = find(key);
        if (!found) refuse("must have \"" + key + "\"");
        return *found;
    }
    std::optional<JsonPlace> find(const std::string& key) const {
        const auto found = object().find(key);
        if (found == value_->end()) return {};
        return JsonPlace(*found, member_place(place_, key));
    }
    /// Refuses an object without these keys, or with others than these and the optional ones. what: it is called.
    void keys(std::string_view what, std::initializer_list<const char*> needed,
              std::initializer_list<const char*> optional = {}) const {
        for (const char* key : needed) at(key);
        for (const auto& member : value_->items()) {
            const auto is_its = [&](const char* key) { return member.key() == key; };
            if (std::any_of(needed.begin(), needed.end(), is_its) ||
                std::any_of(optional.begin(), optional.end(), is_its))
                continue;
            std::string allowed;
            for (const auto& list : {needed, optional})
                for (const char* key : list) allowed += (allowed.empty() ? "" : ", ") + std::string(key);
            JsonPlace(member.value(), member_place(place_, member.key()))
                .refuse("is no key of " + std::string(what) + ", whose keys are " + allowed);
        }
    }

private:
    const Json* value_;
    std::string place_;
};

/// A text that is JSON.
struct JsonText {
    Json root;
    std::map<std::string, std::vector<std::string>> order;  ///< of the root's members that are objects: their keys
};

/// Where objects and lists are while JSON is read, told by the events of nlohmann's parser.
class JsonWatch {
public:
    struct Level {
        bool object;
        std::set<std::string> keys{};
        std::string key{};
        std::size_t item = 0;
    };
    const std::vector<Level>& levels() const { return levels_; }
    std::string place() const {
        std::string y;
        for (const Level& level : levels_) y = level.object ? member_place(y, level.key) : item_place(y, level.item);
        return y.empty() ? "JSON text" : y;
    }
    /// False: a key twice in one object.
    bool take(Json::parse_event_t event, const Json& value) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) {
            levels_.push_back({event == Event::object_start});
        } else if (event == Event::key) {
            levels_.back().key = value.get_ref<const std::string&>();
            return levels_.back().keys.insert(levels_.back().key).second;
        } else {
            if (event != Event::value) levels_.pop_back();
            if (!levels_.empty() && !levels_.back().object) ++levels_.back().item;
        }
        return true;
    }

private:
    std::vector<Level> levels_;
};

/// Characters that tell how many of them were read.
struct CountingCharacters {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;
    const char* at;
    const char** last;
    reference operator*() const { return *at; }
    CountingCharacters& operator++() {
        *last = ++at;
        return *this;
    }
    CountingCharacters operator++(int) {
        CountingCharacters y = *this;
        ++*this;
        return y;
    }
    bool operator==(const CountingCharacters& other) const { return at == other.at; }
    bool operator!=(const CountingCharacters& other) const { return at != other.at; }
};

/// Where in a text that is JSON the characters of the string begin that is at this place; its end where there is none.
inline std::size_t string_at(std::string_view text, const std::string& place) {
    const char *const first = text.data(), *last = first, *end = nullptr;
    JsonWatch watch;
    const auto look = [&](int, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::value && value.is_string() && watch.place() == place) end = last;
        watch.take(event, value);
        return true;
    };
    const Json json =
        Json::parse(CountingCharacters{first, &last}, CountingCharacters{first + text.size(), &last}, look);
    if (!end) return text.size();
    // from the quotation mark behind it to the one before it
    const char* at = end - 2;
    const auto escaped = [&](const char* c) {
        bool y = false;
        for (--c; c >= first && *c == '\\'; --c) y = !y;
        return y;
    };
    while (at > first && !(*at == '"' && !escaped(at))) --at;
    return static_cast<std::size_t>(at + 1 - first);
}

/// Throws JsonError unless the text is JSON of at most so many bytes, with objects and lists in each other no deeper
/// than `most_depth`, of numbers that a double can hold, and no key twice in one object.
inline JsonText parse_json(std::string_view text, std::size_t most_bytes, std::size_t most_depth) {
    if (text.size() > most_bytes)
        throw JsonError("JSON text", std::to_string(text.size()) + " bytes",
                        "must have at most " + std::to_string(most_bytes) + " bytes");
    JsonWatch place;
    JsonText y;
    using Event = Json::parse_event_t;
    const auto watch = [&](int, Event event, Json& value) {
        if ((event == Event::object_start || event == Event::array_start) && place.levels().size() == most_depth)
            throw JsonError(place.place(), event == Event::object_start ? "{" : "[",
                            "must not be deeper than " + std::to_string(most_depth) + " objects and lists");
        if (!place.take(event, value))
            throw JsonError(place.place(), in_short(value), "must not be a key twice in one object");
        const auto& levels = place.levels();
        if (event == Event::key && levels.size() == 2) y.order[levels[0].key].push_back(levels[1].key);
        return true;
    };
    try {
        y.root = Json::parse(text.begin(), text.end(), watch);
    } catch (const Json::out_of_range&) {
        throw JsonError(place.place(), "out of range", "must be a number that a double can hold");
    } catch (const Json::parse_error& e) {
        // "[...] parse error at line 1, column 2: what is wrong; last read: 'as much as it likes'; what is expected"
        std::string wrong = e.what(), at = "JSON text";
        if (const auto end = wrong.find("] "); end != wrong.npos) wrong.erase(0, end + 2);
        const auto line = wrong.find("line "), colon = wrong.find(": ");
        if (line != wrong.npos && colon != wrong.npos && line < colon) {
            at += ", " + wrong.substr(line, colon - line);
            wrong.erase(0, colon + 2);
        }
        if (const auto read = wrong.find("; last read: '"); read != wrong.npos) {
            const auto after = wrong.rfind("'; expected ");
            wrong.erase(read, after == wrong.npos || after < read ? wrong.npos : after + 1 - read);
        }
        const std::size_t end = std::min(e.byte, text.size()), begin = end - std::min<std::size_t>(end, 20);
        std::string read(begin > 0 ? "..." : "");
        for (const char c : text.substr(begin, end - begin)) read += c < ' ' || c > '~' ? '?' : c;
        throw JsonError(at, "'" + read + "'", "must be JSON: " + wrong);
    }
    return y;
}

}  // namespace equilibria::detail
