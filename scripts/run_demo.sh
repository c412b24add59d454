#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages, builds the tool in build/ and maps the armadillo of CGAL to the sphere, with both weights.
# Then it mends two broken meshes and does the same with them, one command each. Everything it makes is in demo/ afterwards:
# spheres, coloured meshes, reports, textured meshes for any viewer (.glb), a page to look at (armadillo.html) and, where f3d
# runs, pictures.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
demo=$root/demo

"$root/scripts/install_dependencies.sh"
cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release -DCGAL_SP_WITH_TBB=ON -DCGAL_SP_WITH_OPENCL=ON
cmake --build "$root/build" --parallel "$(nproc)" --target spherical-parameterization
tool=$root/build/src/spherical-parameterization

mkdir -p "$demo"
meshes=/usr/share/doc/libcgal-dev/data.tar.gz
[ -e "$meshes" ] || meshes=/usr/share/doc/libcgal-demo/data.tar.gz
tar -xzf "$meshes" -C "$demo" --strip-components=2 data/meshes/{armadillo,elephant-with-holes,eight}.off

# picture PNG PLY options...: of the colours of a PLY file; no picture where there is no f3d or no display for it
picture() {
  local png=$1 ply=$2
  shift 2
  timeout 300 xvfb-run -a f3d --dry-run --quiet --output "$png" "$ply" --resolution=1200,1200 --up=+Y --bg-color=1,1,1 \
    --fxaa --tone-mapping --roughness=0.6 --scalars=RGB --comp=-2 "$@" </dev/null >/dev/null 2>&1 || rm -f "$png"
}

# coloured_sphere SPHERE.off COLOURED.ply: the coloured mesh with its vertices moved to the sphere
coloured_sphere() {
  awk 'NR == FNR { if(FNR > 2) position[FNR - 3] = $1 " " $2 " " $3; next }
       in_body && i < n { $1 = $2 = $3 = ""; print position[i++] $0; next }
       { print }
       /^element vertex/ { n = $3 }
       /^end_header/ { in_body = 1 }' "$1" "$2"
}

for weights in barycentric conformal; do
  out=$demo/armadillo_$weights
  echo
  echo "== armadillo, $weights weights"
  "$tool" map "$demo/armadillo.off" --method balanced --weights "$weights" -o "${out}_sphere.off" \
    --stretch-ply "${out}_stretch.ply" --ascii \
    --report "$out.json" </dev/null
  coloured_sphere "${out}_sphere.off" "${out}_stretch.ply" >"${out}_sphere_stretch.ply"
  picture "${out}_stretch.png" "${out}_stretch.ply" \
    --camera-azimuth-angle=155 --camera-elevation-angle=8 --camera-view-angle=22
  picture "${out}_sphere.png" "${out}_sphere_stretch.ply" --edges --line-width=1 \
    --camera-azimuth-angle=35 --camera-elevation-angle=15 --camera-view-angle=18
done

# What map does not take: holes, and two handles. prepare says what and where, and mends it; then it is mapped, certified and textured.
for broken in elephant-with-holes eight; do
  out=$demo/$broken
  echo
  echo "== $broken: prepared, mapped, certified, textured"
  "$tool" prepare "$out.off" -o "${out}_prepared.off" --vertex-map "${out}_vertices.txt" --report "$out.json" </dev/null
  "$tool" map "${out}_prepared.off" -o "${out}_sphere.off" --stretch-ply "${out}_stretch.ply" </dev/null
  "$tool" certify "${out}_prepared.off" "${out}_sphere.off" </dev/null
  "$tool" texture "${out}_prepared.off" --sphere "${out}_sphere.off" -o "$out.glb" </dev/null
  elevation=0
  [ "$broken" = elephant-with-holes ] || elevation=70 # on its handles
  picture "${out}_stretch.png" "${out}_stretch.ply" --camera-view-angle=26 --camera-elevation-angle="$elevation"
done

echo
"$tool" texture "$demo/armadillo.off" --sphere "$demo/armadillo_conformal_sphere.off" -o "$demo/armadillo.glb" </dev/null
"$tool" view "$demo/armadillo.off" -o "$demo/armadillo.html" </dev/null

echo
echo "Written to $demo:"
ls "$demo"
