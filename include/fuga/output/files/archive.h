// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_files_archive_h
#define fuga_output_files_archive_h

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace fuga
{
  /**
   * Stores values as JSON in its binary form CBOR such that every number is restored bit for bit
   * (including NaN, signed zero and denormals): a double is stored as the integer with its bits, an
   * array of numbers as bytes. Classes take part by for_each_field(), see base/fields.h; every
   * field is stored under its name. The files have to be read on the machine that wrote them.
   */
  namespace archive
  {
    using Json = nlohmann::json;

    namespace internal
    {
      struct AnyVisitor
      {
        template <typename Value>
        void
        operator()(const char *, Value &)
        {
        }
      };

      template <typename Value, typename = void>
      struct HasFields : std::false_type
      {
      };
      template <typename Value>
      struct HasFields<Value,
                       std::void_t<decltype(for_each_field(std::declval<Value &>(), AnyVisitor()))>>
        : std::true_type
      {
      };

      template <typename Value>
      struct IsPair : std::false_type
      {
      };
      template <typename A, typename B>
      struct IsPair<std::pair<A, B>> : std::true_type
      {
      };

      template <typename Value>
      struct IsVector : std::false_type
      {
      };
      template <typename Item>
      struct IsVector<std::vector<Item>> : std::true_type
      {
      };

      inline Json
      bytes(const void *data, const std::size_t size)
      {
        const auto *begin = static_cast<const std::uint8_t *>(data);
        return Json::binary(size == 0 ? std::vector<std::uint8_t>()
                                      : std::vector<std::uint8_t>(begin, begin + size));
      }

      /** Return the bytes of a binary value, which must have the given size. */
      inline const std::uint8_t *
      bytes_of(const Json &json, const std::size_t size)
      {
        const auto &items = json.get_ref<const Json::binary_t &>();
        if (items.size() != size)
          throw std::length_error("another number of bytes");
        return items.data();
      }
    } // namespace internal

    /** Convert a value to JSON. */
    template <typename Value>
    Json
    encode(const Value &value)
    {
      if constexpr (internal::HasFields<const Value>::value)
        {
          Json object = Json::object();
          for_each_field(value, [&object](const char *name, const auto &field) {
            object[name] = encode(field);
          });
          return object;
        }
      else if constexpr (std::is_same_v<Value, double>)
        {
          std::uint64_t bits;
          std::memcpy(&bits, &value, sizeof(bits));
          return bits;
        }
      else if constexpr (std::is_enum_v<Value>)
        return static_cast<std::int64_t>(value);
      else if constexpr (std::is_integral_v<Value> || std::is_same_v<Value, std::string> ||
                         std::is_same_v<Value, std::map<std::string, std::size_t>>)
        return value;
      else if constexpr (internal::IsPair<Value>::value)
        return Json::array({encode(value.first), encode(value.second)});
      else if constexpr (std::is_same_v<Value, std::vector<bool>>)
        {
          const std::vector<std::uint8_t> items(value.begin(), value.end());
          return internal::bytes(items.data(), items.size());
        }
      else if constexpr (internal::IsVector<Value>::value)
        {
          using Item = typename Value::value_type;
          if constexpr (std::is_trivially_copyable_v<Item>)
            return internal::bytes(value.data(), value.size() * sizeof(Item));
          else
            {
              Json list = Json::array();
              for (const Item &item : value)
                list.push_back(encode(item));
              return list;
            }
        }
      else
        {
          static_assert(std::is_trivially_copyable_v<Value>, "a kind of value not provided for");
          return internal::bytes(&value, sizeof(value));
        }
    }

    /**
     * Restore a value from the output of encode(). @throws std::exception if it is anything else.
     */
    template <typename Value>
    void
    decode(const Json &json, Value &value)
    {
      if constexpr (internal::HasFields<Value>::value)
        for_each_field(value,
                       [&json](const char *name, auto &field) { decode(json.at(name), field); });
      else if constexpr (std::is_same_v<Value, double>)
        {
          const auto bits = json.get<std::uint64_t>();
          std::memcpy(&value, &bits, sizeof(bits));
        }
      else if constexpr (std::is_enum_v<Value>)
        value = static_cast<Value>(json.get<std::int64_t>());
      else if constexpr (std::is_integral_v<Value> || std::is_same_v<Value, std::string> ||
                         std::is_same_v<Value, std::map<std::string, std::size_t>>)
        json.get_to(value);
      else if constexpr (internal::IsPair<Value>::value)
        {
          decode(json.at(0), value.first);
          decode(json.at(1), value.second);
        }
      else if constexpr (std::is_same_v<Value, std::vector<bool>>)
        {
          const auto &items = json.get_ref<const Json::binary_t &>();
          value.assign(items.begin(), items.end());
        }
      else if constexpr (internal::IsVector<Value>::value)
        {
          using Item = typename Value::value_type;
          if constexpr (std::is_trivially_copyable_v<Item>)
            {
              const std::size_t size = json.get_ref<const Json::binary_t &>().size();
              value.resize(size / sizeof(Item));
              const std::uint8_t *bytes = internal::bytes_of(json, value.size() * sizeof(Item));
              if (!value.empty())
                std::memcpy(value.data(), bytes, size);
            }
          else
            {
              value.clear();
              for (const Json &item : json)
                decode(item, value.emplace_back());
            }
        }
      else
        {
          static_assert(std::is_trivially_copyable_v<Value>, "a kind of value not provided for");
          std::memcpy(&value, internal::bytes_of(json, sizeof(value)), sizeof(value));
        }
    }
  } // namespace archive
} // namespace fuga

#endif
