/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * What every kernel is made of: its arguments, the loop over i, and sums.
 *
 * A GPU runs the 64 work-items of a group at once. A CPU runs them one after the other, and barriers are what costs
 * most: there a group is one work-item, which does a block of elements as a thread of the host would.
 */
#define LANES 64
#define BLOCK 1024

#ifdef CGAL_SP_CPU
#define WORK_ITEMS 1
#else
#define WORK_ITEMS LANES
#endif
#define KERNEL __kernel __attribute__((reqd_work_group_size(WORK_ITEMS, 1, 1))) void

/* Structures of pointers cannot be arguments: their members are, and VIEW puts them together again. */
#define MATRIX(a)                                                                                                      \
  int_in a##_offset, int_in a##_target, real_in a##_weight, real_in a##_excess, real_in a##_inverse_diagonal
#define VIEW(a) make_graph_view(a##_offset, a##_target, a##_weight, a##_excess, a##_inverse_diagonal)
#define SMOOTHER(a) int_in a##_offset, int_in a##_target, float_in a##_weight, float_in a##_excess
#define SMOOTHER_VIEW(a) make_smoother_view(a##_offset, a##_target, a##_weight, a##_excess)
#define AGGREGATES(t) int_in t##_of_vertex, int_in t##_offset, int_in t##_member
#define AGGREGATES_VIEW(t) make_aggregates_view(t##_of_vertex, t##_offset, t##_member)

graph_view make_graph_view(int_in offset, int_in target, real_in weight, real_in excess, real_in inverse_diagonal)
{
  graph_view a;
  a.offset = offset;
  a.target = target;
  a.weight = weight;
  a.excess = excess;
  a.inverse_diagonal = inverse_diagonal;
  return a;
}

smoother_view make_smoother_view(int_in offset, int_in target, float_in weight, float_in excess)
{
  smoother_view a;
  a.offset = offset;
  a.target = target;
  a.weight = weight;
  a.excess = excess;
  return a;
}

aggregates_view make_aggregates_view(int_in of_vertex, int_in offset, int_in member)
{
  aggregates_view t;
  t.of_vertex = of_vertex;
  t.offset = offset;
  t.member = member;
  return t;
}

/* FOR_EACH(i, n): the statement after it is executed for each i in 0 ... n-1.
 *
 * SUMS(K) makes room for K sums; the statement after FOR_EACH_OF_BLOCK adds the share of i to s[0] ... s[K-1];
 * ADD_UP(K) hands over the sums of the block. Lane l adds up the elements with i % LANES == l, then the lanes are added
 * pairwise: the order of Host_machine, to the last bit. */
#ifdef CGAL_SP_CPU

#define FOR_EACH(i, n) for(int i = (int)get_group_id(0) * BLOCK, i##_end = min(i + BLOCK, n); i < i##_end; ++i)

#define SUMS(K)                                                                                                        \
  const int number_of_sums = K;                                                                                        \
  real lanes[(K)*LANES] = {0}

#define FOR_EACH_OF_BLOCK(i, n)                                                                                        \
  FOR_EACH(i, n)                                                                                                       \
  for(real* s = lanes + i % LANES * number_of_sums; s; s = 0)

#define ADD_UP(K) add_lanes(K, lanes, partial)

void add_lanes(int count, real* lanes, real_out partial)
{
  for(int half_size = LANES / 2 * count; half_size >= count; half_size /= 2)
    for(int k = 0; k < half_size; ++k)
      lanes[k] += lanes[k + half_size];
  for(int k = 0; k < count; ++k)
    partial[get_group_id(0) * count + k] = lanes[k];
}

#else

#define FOR_EACH(i, n)                                                                                                 \
  const int i = (int)get_global_id(0);                                                                                 \
  if(i < (n))

#define SUMS(K)                                                                                                        \
  __local real lanes[(K)*LANES];                                                                                       \
  real s[K] = {0}

#define FOR_EACH_OF_BLOCK(i, n)                                                                                        \
  for(int turn = 0; turn < BLOCK / LANES; ++turn)                                                                      \
    for(int i = (int)get_group_id(0) * BLOCK + turn * LANES + (int)get_local_id(0); i < (n); i = (n))

#define ADD_UP(K) add_lanes(K, s, lanes, partial)

void add_lanes(int count, const real* s, __local real* lanes, real_out partial)
{
  const int lane = (int)get_local_id(0);
  for(int k = 0; k < count; ++k)
    lanes[k * LANES + lane] = s[k];
  for(int half_size = LANES / 2; half_size > 0; half_size /= 2) {
    barrier(CLK_LOCAL_MEM_FENCE);
    if(lane < half_size)
      for(int k = 0; k < count; ++k)
        lanes[k * LANES + lane] += lanes[k * LANES + lane + half_size];
  }
  if(lane == 0)
    for(int k = 0; k < count; ++k)
      partial[get_group_id(0) * count + k] = lanes[k * LANES];
}

#endif
