// SPDX-License-Identifier: GPL-3.0-or-later
// Property maps with the operations of their concept and not one more.

#ifndef TEST_HELPERS_PROPERTY_MAPS_H
#define TEST_HELPERS_PROPERTY_MAPS_H

#include "helpers/soup.h"

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <map>

namespace test {

/// Readable: get() by value.
template <class Key, class Value>
struct Readable_map {
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;
  std::function<Value(const Key&)> value_of;

  friend Value get(const Readable_map& map, const Key& key) { return map.value_of(key); }
};

/// A sphere as a map of the vertices of a `Mesh`; has to outlive it.
inline Readable_map<Mesh::Vertex_index, Point> on(const Sphere& sphere)
{
  return {[&](const Mesh::Vertex_index& v) { return sphere[v]; }};
}

/// Writable: put() alone. `Value` needs no default constructor.
template <class Key, class Value>
struct Writable_map {
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;
  std::map<Key, Value>* values;

  friend void put(const Writable_map& map, const Key& key, const Value& value)
  {
    map.values->insert_or_assign(key, value);
  }
};

/// Read-write: get() by value, put().
template <class Key, class Value>
struct Read_write_map {
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::read_write_property_map_tag;
  std::map<Key, Value>* values;

  friend Value get(const Read_write_map& map, const Key& key) { return map.values->at(key); }
  friend void put(const Read_write_map& map, const Key& key, const Value& value)
  {
    map.values->insert_or_assign(key, value);
  }
};

} // namespace test

#endif // TEST_HELPERS_PROPERTY_MAPS_H
