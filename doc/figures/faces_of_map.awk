# SPDX-License-Identifier: GPL-3.0-or-later
# awk -f faces_of_map.awk STRETCH.ply SPHERE.off [yes]: the map as PLY with the colours of the mesh that the tool has
# coloured by stretch, one per face; flipped faces are yellow. With a third argument the vertices of SPHERE.off are
# projected to the sphere from their centroid first.
BEGIN { project = ARGV[3] != ""; ARGC = 3; i = v = m = flipped = 0 }
NR == FNR {
  if(/^element vertex/) n = $3
  if(in_body && v < n) { r[v] = $4; g[v] = $5; b[v++] = $6 }
  if(/^end_header/) in_body = 1
  next
}
/^#/ || /^OFF/ || NF == 0 { next }
!m { m = $2; print "ply\nformat ascii 1.0\nelement vertex " n "\nproperty double x\nproperty double y\nproperty double z"; next }
i < n { x[i] = $1; y[i] = $2; z[i++] = $3; next }
i == n { finish_vertices(); ++i }
{
  colour = (r[$2] + r[$3] + r[$4]) / 3 " " (g[$2] + g[$3] + g[$4]) / 3 " " (b[$2] + b[$3] + b[$4]) / 3
  split(colour, c, " ")
  colour = int(c[1]) " " int(c[2]) " " int(c[3])
  # differences first: faces in limbs are tiny
  a = $2; ux = x[$3] - x[a]; uy = y[$3] - y[a]; uz = z[$3] - z[a]; vx = x[$4] - x[a]; vy = y[$4] - y[a]; vz = z[$4] - z[a]
  d = x[a] * (uy * vz - uz * vy) + y[a] * (uz * vx - ux * vz) + z[a] * (ux * vy - uy * vx)
  if(d <= 0) { ++flipped; colour = "255 205 0" }
  print "3", $2, $3, $4, colour
}
END { print flipped " flipped faces of " m >"/dev/stderr" }
function finish_vertices(  k, cx, cy, cz, length_) {
  if(project) {
    for(k = 0; k < n; ++k) { cx += x[k] / n; cy += y[k] / n; cz += z[k] / n }
    for(k = 0; k < n; ++k) {
      x[k] -= cx; y[k] -= cy; z[k] -= cz
      length_ = sqrt(x[k] ^ 2 + y[k] ^ 2 + z[k] ^ 2)
      x[k] /= length_; y[k] /= length_; z[k] /= length_
    }
  }
  print "element face " m "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header"
  for(k = 0; k < n; ++k) print x[k], y[k], z[k]
}
