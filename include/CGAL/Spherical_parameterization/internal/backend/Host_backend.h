// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H

#include <CGAL/Spherical_parameterization/internal/backend/Verbs.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Vectors of floats, in an array of their own or in the memory of vectors, which they overwrite. That saves memory on
/// large meshes.
class Host_steps {
public:
  Host_steps() = default;
  explicit Host_steps(Host_array<float4> own) : own_(std::move(own)), first_(own_.data()), size_(own_.size()) {}
  /// In this memory, if it is aligned; else in an array of their own. Doubles have to be written again before they are
  /// read.
  explicit Host_steps(Host_array<vec3>& memory) : first_(reinterpret_cast<float4*>(memory.data())), size_(memory.size())
  {
    static_assert(sizeof(float4) <= sizeof(vec3));
    if(reinterpret_cast<std::uintptr_t>(first_) % alignof(float4) != 0)
      *this = Host_steps(Host_array<float4>(size_));
  }
  Host_steps(Host_steps&&) = default;
  Host_steps& operator=(Host_steps&&) = default;

  std::size_t size() const { return size_; }
  float4* data() { return first_; }
  const float4* data() const { return first_; }
  float4& operator[](std::size_t i) { return first_[i]; }
  const float4& operator[](std::size_t i) const { return first_[i]; }

private:
  Host_array<float4> own_;
  float4* first_ = nullptr;
  std::size_t size_ = 0;
};

/// A machine whose memory is the host's. One core and all cores differ in nothing but the loop.
template <class Loop>
class Host_machine {
public:
  using Host_loop = Loop;
  template <class T>
  using Array = Host_array<T>;
  using Vectors = Array<vec3>;
  using Scalars = Array<double>;
  using Steps = Host_steps;
  using Floats = Array<float>;
  using Matrix = Shared_graph;
  using Smoother = Shared_smoother;
  using Aggregates = Shared_aggregates;
  using Colouring = std::vector<Array<int>>;

  explicit Host_machine(const Loop& loop = Loop()) : loop_(loop) {}
  template <class ExecutionPolicy>
  explicit Host_machine(const ExecutionPolicy& policy) : loop_(internal::host_loop(policy))
  {}

  std::string device_name() const { return loop_.name(); }

  /// How set-up on the host is run.
  const Loop& host_loop() const { return loop_; }

  /// A bound of the relative rounding error of sums
  double rounding() const { return 1e-13; }

  /// The smallest residual that rounding allows for n vertices; 0 if it does not limit the accuracy.
  double best_accuracy(int) const { return 0; }

  Vectors vectors(int n) const { return filled<vec3>(n, {0, 0, 0}); }
  Steps steps(int n) const { return Steps(filled(n, float4{0, 0, 0, 0})); }
  /// In the memory of x, which they overwrite; valid as long as x is neither resized nor destroyed.
  Steps steps_in(Vectors& x) const { return Steps(x); }
  Scalars scalars(int n) const { return filled<double>(n, 0); }
  /// What the caller keeps is not copied: `const Scalars& x = upload(y)` is `y`.
  template <class T>
  T upload(T&& host) const
  {
    return std::forward<T>(host);
  }
  Smoother upload(Shared_smoother host, const Matrix&) const { return host; }
  const Vectors& download(const Vectors& x) const { return x; }
  Vectors download(Vectors&& x) const { return std::move(x); }
  Colouring colouring(Colouring colours) const { return colours; }

protected:
  template <auto Formula_at, class... Arguments>
  void run(Verb<Formula_at>, std::size_t n, Arguments&... arguments) const
  {
    const auto loop = [&](auto... views) {
      for_each(n, [=](int i) {
        (prefetch(i, views), ...);
        Formula_at(i, views...);
      });
    };
    loop(view(arguments)...);
  }

  /// Lane l of a block adds up the elements i with i % lanes == l. The lanes are added pairwise, then the blocks in
  /// order. The order is that of a work-group (kernels/backend/loops.cl), and the same for any number of threads.
  template <auto Formula_at, int K, class... Arguments>
  std::array<double, K> sum(Verb<Formula_at, K>, std::size_t n, Arguments&... arguments) const
  {
    const int size = static_cast<int>(n);
    std::vector<std::array<double, K>> partial((size + block_size - 1) / block_size);
    const auto sum_blocks = [&](auto... views) {
      for_each_block(size, [&, views...](int block) {
        std::array<std::array<double, K>, lanes> lane{};
        const int end = (std::min)(size, (block + 1) * block_size);
        for(int i = block * block_size; i < end;)
          for(int l = 0; l < lanes && i < end; ++l, ++i) {
            (prefetch(i, views), ...);
            Formula_at(i, views..., lane[l].data());
          }
        for(int half = lanes / 2; half > 0; half /= 2)
          for(int l = 0; l < half; ++l)
            for(int k = 0; k < K; ++k)
              lane[l][k] += lane[l + half][k];
        partial[block] = lane[0];
      });
    };
    sum_blocks(view(arguments)...);
    std::array<double, K> total{};
    for(const auto& s : partial)
      for(int k = 0; k < K; ++k)
        total[k] += s[k];
    return total;
  }

private:
  static constexpr int block_size = 1024;
  static constexpr int lanes = 64;

  /// What a formula sees of an argument of a verb
  template <class Elements>
  static auto view(Elements& x) -> decltype(x.data())
  {
    return x.data();
  }
  static graph_view view(const Matrix& a) { return a->view(); }
  static smoother_view view(const Smoother& a) { return a->view(); }
  static aggregates_view view(const Aggregates& of) { return of->view(); }
  static int view(int k) { return k; }
  static double view(double s) { return s; }
  static vec3 view(vec3 p) { return p; }

  /// Asks for memory that elements later on will need: see doc/balanced_method.md. Arrays that i is no index of are
  /// asked for in vain, which costs little.
  template <class T>
  static void prefetch(int i, const T* x)
  {
    constexpr int elements_ahead = 128;
    prefetch_element(i + std::size_t(elements_ahead), x);
  }
  static void prefetch(int i, const graph_view& a) { prefetch_entries(i, a); }
  static void prefetch(int i, const smoother_view& a) { prefetch_entries(i, a); }
  static void prefetch(int, const aggregates_view&) {}
  static void prefetch(int, int) {}
  static void prefetch(int, double) {}
  static void prefetch(int, vec3) {}
  template <class View>
  static void prefetch_entries(int i, const View& a)
  {
    constexpr int entries_ahead = 1024;
    const std::size_t k = a.offset[i] + std::size_t(entries_ahead);
    prefetch_element(k, a.target);
    prefetch_element(k, a.weight);
  }
  /// x may be null, and k beyond the end: as a number an address does no harm.
  template <class T>
  static void prefetch_element(std::size_t k, const T* x)
  {
    __builtin_prefetch(reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(x) + k * sizeof(T)));
  }

  template <class T>
  Array<T> filled(int n, T value) const
  {
    Array<T> x(n);
    for_each(n, [&](int i) { x[i] = value; });
    return x;
  }

  template <class F>
  void for_each(std::size_t n, F f) const
  {
    const int size = static_cast<int>(n);
    for_each_block(size, [&](int block) {
      const int end = (std::min)(size, (block + 1) * block_size);
      for(int i = block * block_size; i < end; ++i)
        f(i);
    });
  }

  /// A few blocks are run on the calling thread: that is faster than waking other threads.
  template <class F>
  void for_each_block(int n, F f) const
  {
    constexpr int few = 3;
    const int blocks = (n + block_size - 1) / block_size;
    (blocks <= few ? Loop() : loop_).for_each(blocks, f);
  }

  Loop loop_;
};

/// The backend of one core, and that of the threads of the caller's TBB arena
template <class Loop>
using Host_backend = Verbs<Host_machine<Loop>>;

template <class ExecutionPolicy, class Loop>
struct Backend_for {
  using type = Host_backend<Loop>;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_BACKEND_H
