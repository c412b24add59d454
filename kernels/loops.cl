/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * What every kernel is made of: its arguments, the loop over i, and sums. The work-groups of all kernels have 64
 * work-items, so that no driver has to compile a kernel twice.
 */
#define LANES 64
#define BLOCK 1024

#define KERNEL __kernel __attribute__((reqd_work_group_size(LANES, 1, 1))) void

#define VECTORS __global vec3*
#define CONST_VECTORS __global const vec3*
#define SCALARS __global real*
#define CONST_SCALARS __global const real*
#define INDICES __global const int*

/* Structures of pointers cannot be arguments: their members are, and VIEW puts them together again. */
#define MATRIX(a)                                                                                                      \
  INDICES a##_offset, INDICES a##_target, CONST_SCALARS a##_weight, CONST_SCALARS a##_excess,                          \
    CONST_SCALARS a##_inverse_diagonal
#define VIEW(a) make_graph_view(a##_offset, a##_target, a##_weight, a##_excess, a##_inverse_diagonal)
#define TRANSFER(t) INDICES t##_offset, INDICES t##_column, CONST_SCALARS t##_value
#define TRANSFER_VIEW(t) make_sparse_view(t##_offset, t##_column, t##_value)

graph_view make_graph_view(INDICES offset, INDICES target, CONST_SCALARS weight, CONST_SCALARS excess,
                           CONST_SCALARS inverse_diagonal)
{
  graph_view a;
  a.offset = offset;
  a.target = target;
  a.weight = weight;
  a.excess = excess;
  a.inverse_diagonal = inverse_diagonal;
  return a;
}

sparse_view make_sparse_view(INDICES offset, INDICES column, CONST_SCALARS value)
{
  sparse_view t;
  t.offset = offset;
  t.column = column;
  t.value = value;
  return t;
}

/* The statement after it is executed for each i in 0 ... n-1. */
#define FOR_EACH(i, n)                                                                                                 \
  const int i = (int)get_global_id(0);                                                                                 \
  if(i < (n))

/* SUMS(K) declares s[0] ... s[K-1], to which the statement after FOR_EACH_OF_BLOCK adds the share of i; ADD_UP(K) hands
 * over the sums of the block. Lane l adds up the elements with i % LANES == l, then the lanes are added pairwise: the
 * order of Host_backend, to the last bit. */
#define SUMS(K)                                                                                                        \
  __local real lanes[(K)*LANES];                                                                                       \
  real s[K] = {0}

#define FOR_EACH_OF_BLOCK(i, n)                                                                                        \
  for(int turn = 0; turn < BLOCK / LANES; ++turn, IN_STEP)                                                             \
    for(int i = (int)get_group_id(0) * BLOCK + turn * LANES + (int)get_local_id(0); i < (n); i = (n))

/* On a CPU work-items are run one after the other. Without a barrier each would run through its whole share of the
 * block, in strides that no cache likes. */
#ifdef CGAL_SP_CPU
#define IN_STEP barrier(CLK_LOCAL_MEM_FENCE)
#else
#define IN_STEP (void)0
#endif

#define ADD_UP(K) add_lanes(K, s, lanes, partial)

void add_lanes(int count, const real* s, __local real* lanes, SCALARS partial)
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
