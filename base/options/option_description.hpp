#pragma once

#include <concepts>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/options/enum_names.hpp"
#include "base/options/parameter_value.hpp"

namespace fpkcheck::base {

/// Conversion between a data member of an options struct and the variant type Value.
template <class Member>
struct MemberConversion;

template <>
struct MemberConversion<bool> {
  static constexpr ParameterType kType = ParameterType::flag;
  static Value option_value_from_member(bool member) { return member; }
  static void set_member_from_option_value(bool& member, const Value& value) {
    member = std::get<bool>(value);
  }
};
template <std::integral Integer>
requires(!std::same_as<Integer, bool>) struct MemberConversion<Integer> {
  static constexpr ParameterType kType = ParameterType::integer;
  static Value option_value_from_member(Integer member) {
    return static_cast<std::int64_t>(member);
  }
  /// @throws std::out_of_range if the integer type of the data member cannot represent the value
  static void set_member_from_option_value(Integer& member, const Value& value) {
    const auto whole = std::get<std::int64_t>(value);
    if (!std::in_range<Integer>(whole)) throw std::out_of_range("integer");
    member = static_cast<Integer>(whole);
  }
};
template <>
struct MemberConversion<double> {
  static constexpr ParameterType kType = ParameterType::number;
  static Value option_value_from_member(double member) { return member; }
  static void set_member_from_option_value(double& member, const Value& value) {
    member = std::get<double>(value);
  }
};
template <>
struct MemberConversion<std::string> {
  static constexpr ParameterType kType = ParameterType::word;
  static Value option_value_from_member(const std::string& member) { return member; }
  static void set_member_from_option_value(std::string& member, const Value& value) {
    member = std::get<std::string>(value);
  }
};
template <>
struct MemberConversion<NumberOrFormula> {
  static constexpr ParameterType kType = ParameterType::number_or_formula;
  static Value option_value_from_member(const NumberOrFormula& member) {
    return std::visit([](const auto& held) { return Value(held); }, member.held);
  }
  static void set_member_from_option_value(NumberOrFormula& member, const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
      member = *number;
    } else {
      member = std::get<std::string>(value);
    }
  }
};
template <class Enum>
requires std::is_enum_v<Enum>
struct MemberConversion<Enum> {
  static constexpr ParameterType kType = ParameterType::word;
  static Value option_value_from_member(Enum member) { return std::string(name_of(member)); }
  static void set_member_from_option_value(Enum& member, const Value& value) {
    member = *enum_from_name<Enum>(std::get<std::string>(value));
  }
  static std::vector<std::string> enumerator_choices() {
    std::vector<std::string> list;
    for (const auto& entry : enumerator_names(Enum{})) list.emplace_back(entry.name);
    return list;
  }
};
template <class Member>
concept HasEnumChoices = requires {
  MemberConversion<Member>::enumerator_choices();
};

template <class Member>
struct MemberConversion<std::optional<Member>> {
  static constexpr ParameterType kType = MemberConversion<Member>::kType;
  static Value option_value_from_member(const std::optional<Member>& member) {
    return member ? MemberConversion<Member>::option_value_from_member(*member) : Value();
  }
  static void set_member_from_option_value(std::optional<Member>& member, const Value& value) {
    if (is_unset(value)) {
      member.reset();
    } else {
      MemberConversion<Member>::set_member_from_option_value(member.emplace(), value);
    }
  }
  static std::vector<std::string> enumerator_choices() requires HasEnumChoices<Member> {
    return MemberConversion<Member>::enumerator_choices();
  }
};

template <class Member>
concept Resettable = requires(Member member) {
  member.reset();
};

/// The parameters of one options struct, in the order of help texts and tables. Base class of
/// OptionsDescription<Owner>, without the parts that depend on the type `Owner` of the options
/// struct.
class OptionsDescriptionBase {
 public:
  /// @param prefix text before each parameter name in error messages, e.g. "system." or "epc "
  explicit OptionsDescriptionBase(std::string prefix) : prefix_(std::move(prefix)) {}

  const std::vector<Parameter>& parameters() const { return all_; }
  const std::string& prefix() const { return prefix_; }
  const Parameter* find(std::string_view name) const;

 protected:
  Values option_values_of(const void* owner) const;
  Values stored_option_values_of(const void* owner) const;
  /// @throws InputError "GROUP.NAME is missing" or "GROUP.NAME is unknown", or if a value has the
  /// wrong type
  void set_from_values(void* owner, const Values& values, const std::string& group) const;
  /// @throws InputError "PREFIXname = value (must be ..)" for the first parameter whose value is
  /// out of range
  void require_values_in_range(const void* owner) const;
  /// @throws InputError "LABEL value (must be ..)" if the text is not a value of the parameter's
  /// type
  void parse_and_set(void* owner, const Parameter& parameter, std::string_view text,
                     const std::string& label) const;
  void set(void* owner, const Parameter& parameter, const Value& value,
           const std::string& label) const;

  std::string prefix_;
  std::vector<Parameter> all_;
};

/// The parameters of the options struct `Owner`, each with name, help text, range and data member.
///
///     const auto description = OptionsDescription<Options>("epc ")
///                                  .add("order", &Options::order, {"N", "degree n"}, positive_numbers());
template <class Owner>
class OptionsDescription : public OptionsDescriptionBase {
 public:
  using OptionsDescriptionBase::OptionsDescriptionBase;

  struct HelpText {
    std::string
        placeholder;  ///< placeholder of the value in help texts, such as "N" in `--order N`
    std::string help;
  };

  /// Adds a parameter whose command-line flag is its name with dashes in place of underscores.
  template <class Member>
  OptionsDescription&& add(const std::string& name, Member Owner::*member, HelpText text,
                           std::optional<AdmissibleRange> range = {}) && {
    using Held = MemberConversion<Member>;
    Parameter parameter{.name = name,
                        .help = std::move(text.help),
                        .placeholder = std::move(text.placeholder),
                        .flag = with_dashes(name),
                        .type = Held::kType,
                        .can_be_automatic = Resettable<Member>,
                        .range = std::move(range)};
    parameter.get = [member](const void* owner) {
      return Held::option_value_from_member(static_cast<const Owner*>(owner)->*member);
    };
    parameter.set = [member](void* owner, const Value& value) {
      Held::set_member_from_option_value(static_cast<Owner*>(owner)->*member, value);
    };
    if constexpr (HasEnumChoices<Member>)
      parameter.choices = MemberConversion<Member>::enumerator_choices();
    all_.push_back(std::move(parameter));
    return std::move(*this);
  }
  /// Replaces the command-line flag of the last added parameter; an empty text removes the flag.
  OptionsDescription&& with_flag(const std::string& flag) && {
    all_.back().flag = flag;
    return std::move(*this);
  }
  OptionsDescription&& without_flag() && { return std::move(*this).with_flag(""); }
  OptionsDescription&& with_symbol(const std::string& plain, const std::string& typeset) && {
    all_.back().symbol = plain;
    all_.back().typeset = typeset;
    return std::move(*this);
  }
  OptionsDescription&& with_choices(std::vector<std::string> choices) && {
    all_.back().choices = std::move(choices);
    return std::move(*this);
  }
  /// Sets the function that abbreviates a long word of the last added parameter for display.
  OptionsDescription&& with_display_text(
      std::function<std::string(const std::string& word)> display_text) && {
    all_.back().display_text = std::move(display_text);
    return std::move(*this);
  }
  /// Sets the default value of the parameter that was added last. The default value is used if a
  /// file does not contain the key of the parameter.
  OptionsDescription&& with_default(Value value) && {
    all_.back().default_value = std::move(value);
    return std::move(*this);
  }
  /// Sets the default value of the parameter that was added last. Files and tables omit the
  /// parameter if its value equals the default value.
  OptionsDescription&& with_default_omitted_from_files(Value default_value) && {
    all_.back().omit_default = true;
    return std::move(*this).with_default(std::move(default_value));
  }

  Values values(const Owner& owner) const { return option_values_of(&owner); }
  /// Returns the values of all parameters that files store, without default values that need not be
  /// stored (omit_default).
  Values stored_values(const Owner& owner) const { return stored_option_values_of(&owner); }

  /// Builds an options struct from the values of its parameters. The ranges of the parameters are
  /// not checked (see validate()).
  /// @param group name of the group of parameters in error messages, e.g. "options"
  /// @throws InputError that names a parameter if the parameter is missing, unknown or of the wrong
  /// type
  Owner read(const Values& values, const std::string& group) const {
    Owner owner{};
    set_from_values(&owner, values, group);
    return owner;
  }

  /// @throws InputError that states name, value and range of the first parameter whose value is out
  /// of range
  void validate(const Owner& owner) const { require_values_in_range(&owner); }

  /// Parses the text of a parameter's value and assigns the value to a data member of `owner`.
  /// @param label name of the parameter in error messages, e.g. "--order"
  /// @throws InputError if the text is not a value of the parameter's type
  void parse(Owner& owner, const Parameter& parameter, std::string_view text,
             const std::string& label) const {
    parse_and_set(&owner, parameter, text, label);
  }
  void assign_option_value(Owner& owner, const Parameter& parameter, const Value& value,
                           const std::string& label) const {
    set(&owner, parameter, value, label);
  }

 private:
  static std::string with_dashes(std::string name) {
    for (char& c : name) c = c == '_' ? '-' : c;
    return name;
  }
};

}  // namespace fpkcheck::base
