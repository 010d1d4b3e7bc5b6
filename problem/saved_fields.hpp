#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace fpkcheck::problem {

/// Reads an object of a saved run field by field. Every field must be there, of the right type, and
/// in the end none may be left that nobody asked for: what was saved by another version is refused
/// and not guessed.
class SavedFields {
 public:
  /// @param object is kept by reference
  /// @param what   how messages name it, e.g. "options"
  /// @throws InputError when it is no object
  SavedFields(const nlohmann::ordered_json& object, std::string what);

  /// The field of this name.
  /// @throws InputError on one line, naming the field, what it holds and what it must be (all)
  double number(const std::string& key);
  std::optional<double> number_or_null(const std::string& key);
  int integer(const std::string& key);
  std::optional<int> integer_or_null(const std::string& key);
  std::uint64_t count(const std::string& key);  ///< an integer that is not negative
  bool flag(const std::string& key);
  std::string text(const std::string& key);

  /// The value whose name(value) the field holds.
  template <class Enum>
  Enum choice(const std::string& key, std::initializer_list<Enum> known) {
    const std::string saved = text(key);
    std::string names;
    for (const Enum value : known) {
      if (saved == name(value)) return value;
      names += (names.empty() ? "" : ", ") + std::string(name(value));
    }
    refuse(key, "one of " + names);
  }

  /// A field that says nothing that the others do not.
  void pass_over(const std::string& key) { at(key); }

  /// @throws InputError naming a field that was not read
  void require_all_read() const;

 private:
  const nlohmann::ordered_json& at(const std::string& key);
  [[noreturn]] void refuse(const std::string& key, std::string_view allowed) const;

  const nlohmann::ordered_json& object_;
  std::string what_;
  std::set<std::string> read_;
};

}  // namespace fpkcheck::problem
