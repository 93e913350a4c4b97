// SPDX-License-Identifier: Apache-2.0
//
// SWAGE_EXPORT: makes a plugin library of one class or several. Once per library, at global scope:
//
//   SWAGE_EXPORT(Needle, Jaws)
#pragma once

#include <swage/detail/glue.hpp>

#include <array>
#include <iterator>

#define SWAGE_DETAIL_TEXT_(x) #x
#define SWAGE_DETAIL_TEXT(x) SWAGE_DETAIL_TEXT_(x)

namespace swage {

namespace detail {

/// True for ids as "org.example.clip": two words or more of lower case letters, digits and underscores.
consteval bool reverse_domain(std::string_view id) {
  size_t words = 0;
  while (true) {
    const size_t dot = id.find('.');
    if (!snake_case(id.substr(0, dot))) return false;
    ++words;
    if (dot == std::string_view::npos) return words >= 2;
    id.remove_prefix(dot + 1);
  }
}

/// True for versions as "1.2.0".
consteval bool three_numbers(std::string_view version) {
  int dots = 0;
  char last = '.';
  for (const char c : version) {
    if (c == '.' && last == '.') return false;
    if (c != '.' && (c < '0' || c > '9')) return false;
    dots += c == '.' ? 1 : 0;
    last = c;
  }
  return dots == 2 && last != '.';
}

template <class T>
consteval bool says_who() {
  static_assert(
      requires { std::string_view(T::id); },
      "give the plugin: static constexpr auto id = \"org.example.clip\"");
  static_assert(
      requires { std::string_view(T::version); },
      "give the plugin: static constexpr auto version = \"1.0.0\"");
  static_assert(
      requires { std::string_view(T::name); },
      "give the plugin a name for people: static constexpr auto name");
  static_assert(
      requires { std::string_view(T::summary); },
      "give the plugin one sentence: static constexpr auto summary");
  static_assert(
      requires { std::string_view(T::author); }, "say who made it: static constexpr auto author");
  static_assert(
      requires { std::string_view(T::licence); }, "give its SPDX licence: static constexpr auto licence");
  static_assert(reverse_domain(T::id), "an id is a reverse domain in lower case: org.example.clip");
  static_assert(three_numbers(T::version), "a version is three numbers: 1.2.0");
  static_assert(!std::string_view(T::name).empty() && !std::string_view(T::summary).empty(),
                "empty name or summary");
  return true;
}

/// The descriptor of plugin T.
template <class T>
struct Who {
  static_assert(says_who<T>());
  static_assert(!std::is_abstract_v<T>, "the plugin leaves a function of its kind unwritten");
  static constexpr swage_descriptor descriptor{
      sizeof(swage_descriptor),     T::kKind, T::id, T::version, T::name, T::summary, T::author, T::licence,
      T::template Tables<T>::traits};
};

#if defined(__clang__)
#define SWAGE_DETAIL_COMPILER "clang " __clang_version__
#else
#define SWAGE_DETAIL_COMPILER "g++ " __VERSION__
#endif
#ifdef __OPTIMIZE__
#define SWAGE_DETAIL_OPTIMISED ", optimised"
#else
#define SWAGE_DETAIL_OPTIMISED ", not optimised"
#endif
#if SWAGE_CHECKS
#define SWAGE_DETAIL_CHECKED ", thread checks on"
#else
#define SWAGE_DETAIL_CHECKED ", thread checks off"
#endif

/// Folder of the bundle; set by init.
inline std::string& bundle() {
  static std::string folder;
  return folder;
}

/// The C tables of a library that holds Plugins.
template <class... Plugins>
struct Library {
  static_assert(sizeof...(Plugins) > 0, "SWAGE_EXPORT needs at least one plugin");
  static constexpr std::array descriptors{&Who<Plugins>::descriptor...};

  static swage_result init(const char* bundle_dir) noexcept {
    try {
      bundle() = bundle_dir != nullptr ? bundle_dir : "";
      return SWAGE_OK;
    } catch (...) {
      return SWAGE_FAULT;
    }
  }
  static void deinit() noexcept {}

  static uint32_t count() noexcept { return sizeof...(Plugins); }
  static const swage_descriptor* descriptor(uint32_t index) noexcept {
    return index < sizeof...(Plugins) ? descriptors[index] : nullptr;
  }
  static swage_instance* create_one(const swage_host* host, const char* id) noexcept {
    swage_instance* made = nullptr;
    static_cast<void>(((same(id, Plugins::id) ? (made = create<Plugins>(host), true) : false) || ...));
    return made;
  }
  static const swage_param* table(const char* id, uint32_t* n) noexcept {
    const swage_param* rows = nullptr;
    *n = 0;
    const auto fill = [&]<class T>() {
      rows = Table<T>::rows();
      *n = Table<T>::count();
      return true;
    };
    try {
      static_cast<void>(((same(id, Plugins::id) ? fill.template operator()<Plugins>() : false) || ...));
    } catch (...) {
      *n = 0;  // the defaults could not be made
    }
    return rows;
  }
  /// A static array of the class of plugin `id`; nullptr and 0 when the class has none.
  template <class Row, class Array>
  static const Row* rows(const char* id, uint32_t* n, Array array) noexcept {
    const Row* found = nullptr;
    *n = 0;
    const auto fill = [&]<class T>() {
      if constexpr (requires { array.template operator()<T>(); }) {
        const auto& all = array.template operator()<T>();
        found = std::data(all);
        *n = static_cast<uint32_t>(std::size(all));
      }
      return true;
    };
    static_cast<void>(((same(id, Plugins::id) ? fill.template operator()<Plugins>() : false) || ...));
    return found;
  }
  /// The card of a lesson: the arrays `metrics`, `cues`, `labels` and `criteria` of its class.
  static const swage_metric_info* metrics(const char* id, uint32_t* n) noexcept {
    return rows<swage_metric_info>(id, n, []<class T>() -> const auto& requires requires { T::metrics; } { return T::metrics; });
  }
  static const swage_cue_info* cues(const char* id, uint32_t* n) noexcept {
    return rows<swage_cue_info>(id, n, []<class T>() -> const auto& requires requires { T::cues; } { return T::cues; });
  }
  static const swage_metric_label* labels(const char* id, uint32_t* n) noexcept {
    return rows<swage_metric_label>(id, n, []<class T>() -> const auto& requires requires { T::labels; } { return T::labels; });
  }
  static const swage_criterion* criteria(const char* id, uint32_t* n) noexcept {
    return rows<swage_criterion>(id, n, []<class T>() -> const auto& requires requires { T::criteria; } { return T::criteria; });
  }
  static const void* get_factory(const char* id) noexcept {
    static constexpr swage_factory instances{count, descriptor, create_one};
    static constexpr swage_param_factory params{table};
    static constexpr swage_lesson_card_factory card{metrics, cues};
    static constexpr swage_lesson_labels_factory labelled{labels, criteria};
    if (same(id, SWAGE_FACTORY_INSTANCES)) return &instances;
    if (same(id, SWAGE_FACTORY_PARAMS)) return &params;
    if (same(id, SWAGE_FACTORY_LESSON_CARD)) return &card;
    if (same(id, SWAGE_FACTORY_LESSON_LABELS)) return &labelled;
    return nullptr;
  }
};

}  // namespace detail

/// Folder of the bundle, for the plugin's own resources; known once the library is loaded. [main]
inline const std::string& bundle_dir() { return detail::bundle(); }

/// The object of class T behind an instance, for the functions of a table of your own (Instance::extension). Only for instances of T,
/// from configure() on. [any]
template <class T>
T& self(swage_instance* instance) {
  return *detail::Holder<T>::of(instance).plugin;
}

/// Makes the entry that SWAGE_EXPORT exports; tests can use one without a library.
template <class... Plugins>
constexpr swage_entry make_entry() {
  using L = detail::Library<Plugins...>;
  constexpr const char* build = SWAGE_DETAIL_COMPILER SWAGE_DETAIL_OPTIMISED SWAGE_DETAIL_CHECKED
      ", C++ " SWAGE_DETAIL_TEXT(__cplusplus);
  return {sizeof(swage_entry), SWAGE_ABI_MAJOR, SWAGE_ABI_MINOR, 0, build, L::init,
          L::deinit,           L::get_factory};
}

}  // namespace swage

/// Defines the one symbol that a plugin library exports.
#define SWAGE_EXPORT(...)                                                             \
  extern "C" {                                                                        \
  __attribute__((visibility("default"))) extern const swage_entry swage_plugin_entry; \
  constexpr swage_entry swage_plugin_entry = swage::make_entry<__VA_ARGS__>();        \
  }
