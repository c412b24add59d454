// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_COUNTING_POLICY_H
#define BENCHMARK_COUNTING_POLICY_H

// The solvers are compiled for this policy, too, which the compiled library does not know.
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/driver/solve_impl.h>
#include <CGAL/Spherical_parameterization/internal/balanced/solve_balanced_impl.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point_impl.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace benchmark {

/// An execution policy like `CGAL::Sequential_tag` that counts the work of the solvers in entries of sparse matrices:
/// an edge of a weighted graph, seen from one end, each time that it is used.
/// What is left out are vector operations and the set-up of the hierarchy.
struct Counting_policy {
  std::size_t* entries;
};

} // namespace benchmark

namespace CGAL::Spherical_parameterization::internal {

class Counting_machine : public Host_machine<Host_loop> {
  typedef Host_machine<Host_loop> Base;

public:
  explicit Counting_machine(const benchmark::Counting_policy& policy) : entries_(*policy.entries) {}
  std::string device_name() const { return "one core, counting"; }

protected:
  template <class Verb, class... Arguments>
  void run(Verb verb, std::size_t n, Arguments&... arguments) const
  {
    count(n, arguments...);
    Base::run(verb, n, arguments...);
  }
  template <class Verb, class... Arguments>
  auto sum(Verb verb, std::size_t n, Arguments&... arguments) const
  {
    count(n, arguments...);
    return Base::sum(verb, n, arguments...);
  }

private:
  /// The entries of n rows, on average: a Gauss-Seidel sweep goes through one colour after the other.
  template <class... Arguments>
  void count(std::size_t n, const Arguments&... arguments) const
  {
    const auto add = [&](const auto& x) {
      if constexpr(std::is_same_v<decltype(x), const Matrix&> || std::is_same_v<decltype(x), const Smoother&>)
        entries_ += n * x->weight.size() / x->size();
    };
    (add(arguments), ...);
  }

  std::size_t& entries_;
};

template <class Loop>
struct Backend_for<benchmark::Counting_policy, Loop> {
  using type = Verbs<Counting_machine>;
};
template <>
struct Is_policy<benchmark::Counting_policy> : std::true_type {};

} // namespace CGAL::Spherical_parameterization::internal

#endif // BENCHMARK_COUNTING_POLICY_H
