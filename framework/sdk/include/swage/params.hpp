// SPDX-License-Identifier: Apache-2.0
//
// The parameter table of a plugin: one line per member of its Params struct.
//
//   struct NeedleParams {
//     double wire_diameter = 0.1e-3;  // m   <- the default lives here and nowhere else
//   };
//   static constexpr std::array fields = {
//       swage::real<&NeedleParams::wire_diameter>("wire_diameter", "Wire diameter", "m", "mm", 0.03e-3, 1e-3,
//                                                 "Diameter of the body of the needle."),
//   };
//
// A mistake in a line (an id that is not snake_case, min above max, a member of the wrong type) does not
// compile.
#pragma once

#include <swage/abi/params.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace swage {

/// For a plugin without parameters.
struct NoParams {};

/// A range of a quantity, as in "from 0.5 to 0.75 of the arc".
struct Interval {
  double low = 0, high = 0;
};

/// One line of the table. Made by the functions below; flags are added by chaining.
struct Field {
  swage_param param{};
  void (*assign)(void* params, const swage_value& value) = nullptr;                 // host's value -> member
  void (*read)(const void* params, double number[4], const char** text) = nullptr;  // member -> default

  /// May change while the scene runs; the host then calls changed(). Not for texts and files.
  consteval Field live() const {
    if (param.type == SWAGE_PARAM_TEXT || param.type == SWAGE_PARAM_FILE) throw "a text cannot be live";
    return with(SWAGE_PARAM_LIVE);
  }
  /// A lesson must give it.
  consteval Field required() const { return with(SWAGE_PARAM_REQUIRED); }
  /// Shown under "advanced".
  consteval Field hidden() const { return with(SWAGE_PARAM_HIDDEN); }
  /// Section of the form.
  consteval Field group(const char* title) const {
    Field field = *this;
    field.param.group = title;
    return field;
  }
  /// Former ids; NULL-terminated, static.
  consteval Field aliases(const char* const* ids) const {
    Field field = *this;
    field.param.aliases = ids;
    return field;
  }

 private:
  consteval Field with(uint32_t flag) const {
    Field field = *this;
    field.param.flags |= flag;
    return field;
  }
};

namespace detail {

template <auto Member>
struct MemberOf;
template <class P, class T, T P::*Member>
struct MemberOf<Member> {
  using Params = P;
  using Type = T;
  static T& in(void* params) { return static_cast<P*>(params)->*Member; }
  static const T& in(const void* params) { return static_cast<const P*>(params)->*Member; }
};

template <class T>
inline constexpr bool kIsInteger = std::integral<T> && !std::same_as<T, bool>;

/// True for lower case letters, digits and single underscores, starting with a letter.
constexpr bool snake_case(std::string_view id) {
  if (id.empty() || id.front() < 'a' || id.front() > 'z' || id.back() == '_') return false;
  char last = 0;
  for (const char c : id) {
    const bool allowed = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    if (!allowed || (c == '_' && last == '_')) return false;
    last = c;
  }
  return true;
}

constexpr swage_param new_param(int32_t type, const char* id, const char* label, const char* doc) {
  if (!snake_case(id)) throw "the id of a parameter is snake_case: wire_diameter";
  if (std::string_view(label).empty()) throw "a parameter needs a label for people";
  if (std::string_view(doc).empty()) throw "a parameter needs one or two sentences of documentation";
  swage_param param{};
  param.struct_size = sizeof(swage_param);
  param.type = type;
  param.dimension = 1;
  param.id = id;
  param.label = label;
  param.group = "";
  param.unit = "1";
  param.display_unit = "1";
  param.doc = doc;
  return param;
}

constexpr void set_range(swage_param& param, const char* unit, const char* display, double min, double max) {
  if (!(min <= max)) throw "min must not be above max";
  param.unit = unit;
  param.display_unit = display;
  param.min = min;
  param.max = max;
}

template <class T>
struct Components;
template <size_t N>
struct Components<std::array<double, N>> {
  static constexpr uint32_t count = N;
  static double* of(std::array<double, N>& v) { return v.data(); }
  static const double* of(const std::array<double, N>& v) { return v.data(); }
};
template <>
struct Components<swage_vec3> {
  static constexpr uint32_t count = 3;
  static double* of(swage_vec3& v) { return &v.x; }
  static const double* of(const swage_vec3& v) { return &v.x; }
};
template <>
struct Components<Interval> {
  static constexpr uint32_t count = 2;
  static double* of(Interval& v) { return &v.low; }
  static const double* of(const Interval& v) { return &v.low; }
};
template <class T>
concept HasComponents = requires {
  Components<T>::count;
}
&&Components<T>::count >= 2 && Components<T>::count <= 4;

template <auto Member, int32_t type>
constexpr Field text_field(const char* id, const char* label, const char* doc) {
  using M = MemberOf<Member>;
  static_assert(std::same_as<typename M::Type, std::string>, "a text or file parameter needs a std::string");
  Field field{new_param(type, id, label, doc), nullptr, nullptr};
  field.assign = [](void* p, const swage_value& v) {
    M::in(p).assign(v.text.data != nullptr ? v.text.data : "", v.text.size);
  };
  field.read = [](const void* p, double*, const char** text) { *text = M::in(p).c_str(); };
  return field;
}

// A consteval function cannot hand its arguments on to another one (clang), to a constexpr one it can.
template <auto Member>
constexpr Field vector_field(const char* id, const char* label, const char* unit, const char* display_unit, double min, double max, const char* doc) {
  using M = MemberOf<Member>;
  static_assert(HasComponents<typename M::Type>, "swage::vector needs a std::array<double, 2..4> or a swage_vec3; swage::interval a swage::Interval");
  using C = Components<typename M::Type>;
  Field field{new_param(SWAGE_PARAM_VECTOR, id, label, doc), nullptr, nullptr};
  set_range(field.param, unit, display_unit, min, max);
  field.param.dimension = C::count;
  field.assign = [](void* p, const swage_value& v) {
    for (uint32_t i = 0; i < C::count; ++i) C::of(M::in(p))[i] = v.number[i];
  };
  field.read = [](const void* p, double n[4], const char**) {
    for (uint32_t i = 0; i < C::count; ++i) n[i] = C::of(M::in(p))[i];
  };
  return field;
}

}  // namespace detail

/// A number with a unit; min and max are inclusive and SI. The member is a double.
template <auto Member>
consteval Field real(const char* id, const char* label, const char* unit, const char* display_unit,
                     double min, double max, const char* doc) {
  using M = detail::MemberOf<Member>;
  static_assert(std::same_as<typename M::Type, double>, "swage::real needs a double");
  Field field{detail::new_param(SWAGE_PARAM_REAL, id, label, doc), nullptr, nullptr};
  detail::set_range(field.param, unit, display_unit, min, max);
  field.assign = [](void* p, const swage_value& v) { M::in(p) = v.number[0]; };
  field.read = [](const void* p, double n[4], const char**) { n[0] = M::in(p); };
  return field;
}

/// A whole number. The member is any integer.
template <auto Member>
consteval Field integer(const char* id, const char* label, int64_t min, int64_t max, const char* doc) {
  using M = detail::MemberOf<Member>;
  using T = typename M::Type;
  static_assert(detail::kIsInteger<T>, "swage::integer needs an integer");
  Field field{detail::new_param(SWAGE_PARAM_INTEGER, id, label, doc), nullptr, nullptr};
  detail::set_range(field.param, "1", "1", static_cast<double>(min), static_cast<double>(max));
  field.assign = [](void* p, const swage_value& v) { M::in(p) = static_cast<T>(v.number[0]); };
  field.read = [](const void* p, double n[4], const char**) { n[0] = static_cast<double>(M::in(p)); };
  return field;
}

/// Yes or no. The member is a bool.
template <auto Member>
consteval Field boolean(const char* id, const char* label, const char* doc) {
  using M = detail::MemberOf<Member>;
  static_assert(std::same_as<typename M::Type, bool>, "swage::boolean needs a bool");
  Field field{detail::new_param(SWAGE_PARAM_BOOL, id, label, doc), nullptr, nullptr};
  field.param.max = 1;
  field.assign = [](void* p, const swage_value& v) { M::in(p) = v.number[0] != 0; };
  field.read = [](const void* p, double n[4], const char**) { n[0] = M::in(p) ? 1 : 0; };
  return field;
}

/// One of a few; `names` ends with nullptr and is static. The member is an integer or an enum: the index of
/// the name.
template <auto Member>
consteval Field choice(const char* id, const char* label, const char* const* names, const char* doc) {
  using M = detail::MemberOf<Member>;
  using T = typename M::Type;
  static_assert(detail::kIsInteger<T> || std::is_enum_v<T>, "swage::choice needs an integer or an enum");
  Field field{detail::new_param(SWAGE_PARAM_CHOICE, id, label, doc), nullptr, nullptr};
  uint32_t count = 0;
  while (names[count] != nullptr) ++count;
  if (count < 2) throw "a choice needs two names or more";
  field.param.choices = names;
  field.param.max = count - 1;
  field.assign = [](void* p, const swage_value& v) {
    M::in(p) = static_cast<T>(static_cast<int64_t>(v.number[0]));
  };
  field.read = [](const void* p, double n[4], const char**) { n[0] = static_cast<double>(M::in(p)); };
  return field;
}

/// Words. The member is a std::string.
template <auto Member>
consteval Field text(const char* id, const char* label, const char* doc) {
  return detail::text_field<Member, SWAGE_PARAM_TEXT>(id, label, doc);
}

/// A file; arrives as an absolute path. The member is a std::string.
template <auto Member>
consteval Field file(const char* id, const char* label, const char* doc) {
  return detail::text_field<Member, SWAGE_PARAM_FILE>(id, label, doc);
}

/// 2 to 4 numbers of one unit; min and max hold for each. The member is a std::array<double, n> or a
/// swage_vec3.
template <auto Member>
consteval Field vector(const char* id, const char* label, const char* unit, const char* display_unit,
                       double min, double max, const char* doc) {
  return detail::vector_field<Member>(id, label, unit, display_unit, min, max, doc);
}

/// From low to high. The member is a swage::Interval.
template <auto Member>
consteval Field interval(const char* id, const char* label, const char* unit, const char* display_unit,
                         double min, double max, const char* doc) {
  static_assert(std::same_as<typename detail::MemberOf<Member>::Type, Interval>,
                "swage::interval needs a swage::Interval");
  Field field = detail::vector_field<Member>(id, label, unit, display_unit, min, max, doc);
  field.param.flags |= SWAGE_PARAM_INTERVAL;
  return field;
}

namespace detail {

/// The table of plugin T for the host, and the conversion of the host's values to Params.
template <class T>
struct Table {
  using Params = typename T::Params;
  static constexpr bool kHasFields = requires { T::fields; };

  static constexpr uint32_t count() {
    if constexpr (kHasFields) return static_cast<uint32_t>(T::fields.size());
    return 0;
  }

  static constexpr bool has_live() {
    if constexpr (kHasFields) {
      for (const Field& field : T::fields)
        if ((field.param.flags & SWAGE_PARAM_LIVE) != 0) return true;
    }
    return false;
  }

  /// Changes one parameter; false when it is not live().
  static bool change(uint32_t index, const swage_value& value, Params& params) {
    if constexpr (kHasFields) {
      if (index >= count() || (T::fields[index].param.flags & SWAGE_PARAM_LIVE) == 0) return false;
      T::fields[index].assign(&params, value);
      return true;
    } else {
      return false;
    }
  }

  static const swage_param* rows() {
    if constexpr (!kHasFields) {
      return nullptr;
    } else {
      // default texts point into `defaults`, so both live for ever
      static const Params defaults{};
      static const auto table = [] {
        std::array<swage_param, T::fields.size()> out{};
        for (size_t i = 0; i < out.size(); ++i) {
          out[i] = T::fields[i].param;
          T::fields[i].read(&defaults, out[i].default_number, &out[i].default_text);
        }
        return out;
      }();
      return table.data();
    }
  }

  static void read(const swage_values* values, Params& params) {
    if constexpr (kHasFields) {
      const uint32_t n = values != nullptr ? values->count : 0;
      for (uint32_t i = 0; i < count() && i < n; ++i) T::fields[i].assign(&params, values->value[i]);
    }
  }
};

}  // namespace detail

}  // namespace swage
