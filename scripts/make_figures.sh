#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# make_figures.sh [FIGURE...]
# Makes figures of the manual and the README, doc/images/, with the package's own tool from CGAL's meshes: those named, or
# all of strip method stretch density segmentation texture morph search harmonics scaling page.
# The errors by degree of the harmonics are also drawn for the meshes in HARMONICS_MODELS, in place of CGAL's bear.
# It installs what it needs, and builds in build/; TOOL=..., MORPH=... and SDF_SEGMENTS=... take programs built elsewhere.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
images=$root/doc/images
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
[ $# -gt 0 ] || set -- strip method stretch density segmentation texture morph search harmonics scaling page

"$root/scripts/install_dependencies.sh" f3d xvfb xauth imagemagick gnuplot-nox
if [ -z "${TOOL:-}" ]; then
  cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release
  cmake --build "$root/build" --parallel "$(nproc)" \
    --target spherical-parameterization example_morph figure_sdf_segments
fi
TOOL=${TOOL:-$root/build/src/spherical-parameterization}
MORPH=${MORPH:-$root/build/examples/example_morph}
SDF_SEGMENTS=${SDF_SEGMENTS:-$root/build/doc/figure_sdf_segments}

meshes=/usr/share/doc/libcgal-dev/data.tar.gz
[ -e "$meshes" ] || meshes=/usr/share/doc/libcgal-demo/data.tar.gz
tar -xzf "$meshes" -C "$work" --strip-components=2 data/meshes
mkdir -p "$images"
cd "$work"

tool() { "$TOOL" "$@" </dev/null; }

# look_at MESH: sets `camera` to the options of f3d that show it best
look_at() {
  camera=(--up=+Y --camera-azimuth-angle=35 --camera-elevation-angle=10)
  case $1 in
  armadillo) camera=(--up=+Y --camera-azimuth-angle=155 --camera-elevation-angle=8) ;;
  dino) camera=(--up=+Z --camera-azimuth-angle=50 --camera-elevation-angle=8) ;;
  hand) camera=(--up=+Z --camera-azimuth-angle=35 --camera-elevation-angle=10) ;;
  man) camera=(--up=+Z --camera-azimuth-angle=15 --camera-elevation-angle=5) ;;
  esac
}

# render IN PNG SIZE OPTIONS...: brightened (what has ${brightest} % of full brightness becomes white), since f3d's only light is dim; twice as large first, against jagged edges.
render() {
  local in=$1 png=$2 size=$3 attempt
  shift 3
  for attempt in 1 2 3 4; do
    timeout 300 xvfb-run -a f3d --dry-run --quiet --output big.png "$in" --resolution=$((2 * size)),$((2 * size)) \
      --bg-color=1,1,1 --roughness=0.8 "$@" </dev/null >/dev/null 2>&1 || continue
    [ "$(identify -format %k big.png)" -eq 1 ] || break
    [ "$attempt" -lt 4 ] || { echo "make_figures.sh: f3d shows nothing of $in" >&2; return 1; }
  done
  convert big.png -level "0,${brightest:-64}%" -trim +repage -resize "${size}x$size" "$png"
}
by_vertices() { render "$@" --scalars=RGB --comp=-2; }
by_faces() { render "$@" --scalars=RGB --cells --comp=-2; }

# panel PNG TEXT SIZE: on a square, with a text under it
panel() {
  convert "$1" -background white -gravity center -extent "${3}x$3" -gravity south -splice 0x34 \
    -font DejaVu-Sans -pointsize 17 -fill '#333333' -annotate +0+7 "$2" "panel_$1"
  echo "panel_$1"
}

# row OUT PANELS...; column OUT ROWS...: and few colours, so that the file is small
row() { convert "${@:2}" -background white +append "$1"; }
finish() { convert "$2" -dither FloydSteinberg -colors 256 -define png:compression-level=9 "PNG8:$images/$1"; }

# map MESH NAME OPTIONS...: NAME.stretch.ply, NAME.sphere.off, and the sphere with the colours of the mesh, NAME.sphere.ply
map() {
  local mesh=$1 name=$2
  shift 2
  tool map "$mesh.off" -o "$name.sphere.off" --stretch-ply "$name.stretch.ply" --ascii "$@" | sed -n 2,3p
  awk -f "$root/doc/figures/faces_of_map.awk" "$name.stretch.ply" "$name.sphere.off" >"$name.sphere.ply"
}

figure_strip() {
  look_at armadillo
  map armadillo a --method balanced
  tool segment armadillo.off --sphere a.sphere.off -o segments.ply --ascii
  awk 'NR == FNR { if(FNR > 2) position[FNR - 3] = $0; next }
       in_body && i < n { print position[i++]; next }
       { print }
       /^element vertex/ { n = $3 }
       /^end_header/ { in_body = 1 }' a.sphere.off segments.ply >sphere.ply
  by_vertices a.stretch.ply s1.png 330 "${camera[@]}"
  by_faces segments.ply s2.png 330 "${camera[@]}"
  by_faces sphere.ply s3.png 290 --up=+Y --camera-azimuth-angle=35 --camera-elevation-angle=15
  tool resample armadillo.off --method isometric --level 5 -o icosphere.ply
  render icosphere.ply s5.png 330 "${camera[@]}" --edges --line-width=1 --color=0.75,0.85,0.95
  tool texture bunny00.off -o bunny.obj
  look_at bunny00
  brightest=90 render bunny.obj s4.png 330 "${camera[@]}"
  row strip.png "$(panel s1.png 'stretch' 340)" "$(panel s2.png 'segments' 340)" \
    "$(panel s3.png 'the sphere: no flipped face' 340)" "$(panel s5.png 'resampled: an icosphere' 340)" \
    "$(panel s4.png 'texture' 340)"
  finish strip.png strip.png
}

figure_method() {
  map homer conformal --method balanced
  map homer barycentric --method balanced --weights barycentric
  map homer isometric --method isometric
  awk -f "$root/doc/figures/faces_of_map.awk" conformal.stretch.ply homer.off project >projected.ply
  look_at homer
  by_vertices conformal.stretch.ply m1.png 300 "${camera[@]}"
  local sphere=(--up=+Y --edges --line-width=1)
  by_faces projected.ply m2.png 280 "${sphere[@]}" --camera-azimuth-angle=35 --camera-elevation-angle=10
  by_faces conformal.sphere.ply m3.png 280 "${sphere[@]}" --camera-azimuth-angle=35
  by_faces barycentric.sphere.ply m4.png 280 "${sphere[@]}" --camera-azimuth-angle=35
  by_faces isometric.sphere.ply m5.png 280 "${sphere[@]}" --camera-azimuth-angle=35
  row method.png "$(panel m1.png 'the mesh' 300)" "$(panel m2.png 'projected from its centroid' 300)" \
    "$(panel m3.png 'conformal' 300)" "$(panel m4.png 'barycentric' 300)" "$(panel m5.png 'isometric' 300)"
  finish method.png method.png
}

figure_density() {
  look_at armadillo
  # eight times as much of the sphere for head and shoulders
  awk '/^#/ || NF == 0 || /^OFF/ { next } !n { n = $1; next } i++ < n { x = $1 < 0 ? -$1 : $1; print 1 + 7 / (1 + exp((42 - $2) / 2)) / (1 + exp((x - 24) / 2)) }' \
    armadillo.off >density.txt
  map armadillo plain --method isometric
  tool map armadillo.off -o dense.sphere.off --density density.txt >/dev/null
  # the mesh in the colours of the density, and both spheres with them
  paste density.txt <(awk '/^end_header/ { in_body = 1; next } in_body { print $1, $2, $3 }' plain.stretch.ply) |
    awk 'NR == FNR { if(NF == 4) line[NR] = $2 " " $3 " " $4 " " int(190 + 5 * $1) " " int(215 - 17 * $1) " " int(240 - 22 * $1) " 0"; next }
         { print in_body && ++i in line ? line[i] : $0 }
         /^end_header/ { in_body = 1 }' - plain.stretch.ply >coloured.ply
  by_vertices coloured.ply d1.png 300 "${camera[@]}"
  local panels=("$(panel d1.png 'density 1 and 8' 310)") choice
  for choice in plain dense; do
    awk -f "$root/doc/figures/faces_of_map.awk" coloured.ply $choice.sphere.off >$choice.ply
    by_faces $choice.ply d_$choice.png 280 --up=+Y --camera-azimuth-angle=100 --camera-elevation-angle=15
  done
  panels+=("$(panel d_plain.png 'isometric' 310)" "$(panel d_dense.png 'with the density' 310)")
  tool resample armadillo.off --density density.txt --level 5 -o icosphere.ply
  render icosphere.ply d4.png 300 "${camera[@]}" --edges --line-width=1 --color=0.75,0.85,0.95
  row density.png "${panels[@]}" "$(panel d4.png 'resampled with it' 310)"
  finish density.png density.png
}

figure_stretch() {
  local rows=()
  for mesh in camel homer; do
    look_at $mesh
    local panels=()
    for choice in barycentric conformal isometric; do
      if [ $choice = isometric ]; then map $mesh x --method isometric; else map $mesh x --method balanced --weights $choice; fi
      by_vertices x.stretch.ply "st_${mesh}_$choice.png" 300 "${camera[@]}"
      red=$(sed -n 's/^comment.*red at //p;/^element/q' x.stretch.ply)
      panels+=("$(panel "st_${mesh}_$choice.png" "$choice: $(awk "BEGIN { printf \"%.0e\", exp(-$red) }")" 320)")
    done
    row "row_$mesh.png" "${panels[@]}"
    rows+=("row_$mesh.png")
  done
  convert "${rows[@]}" -append stretch.png
  finish stretch.png stretch.png
}

figure_segmentation() {
  local ours=() sdf=()
  for mesh in armadillo man dino hand triceratops; do
    look_at $mesh
    tool segment "$mesh.off" -o seg.ply >seg.txt
    by_faces seg.ply "ours_$mesh.png" 290 "${camera[@]}"
    ours+=("$(panel "ours_$mesh.png" "$(sed 's/.*: //' seg.txt)" 300)")
    "$SDF_SEGMENTS" "$mesh.off" sdf.ply >sdf.txt
    by_faces sdf.ply "sdf_$mesh.png" 290 "${camera[@]}"
    sdf+=("$(panel "sdf_$mesh.png" "SDF: $(sed 's/.*: //' sdf.txt)" 300)")
  done
  row ours.png "${ours[@]}"
  row sdf.png "${sdf[@]}"
  convert ours.png sdf.png -append both.png
  finish segmentation.png both.png
}

figure_texture() {
  for mesh in cow bull; do
    look_at $mesh
    for weights in barycentric conformal; do
      tool texture "$mesh.off" --method balanced --weights $weights -o "t_${mesh}_$weights.obj"
      brightest=90 render "t_${mesh}_$weights.obj" t.png 480 "${camera[@]}"
      convert t.png -resize 480x380 -background white -gravity center -extent 500x400 t2.png
      finish "${mesh}_$weights.png" t2.png
    done
  done
}

figure_morph() {
  local panels=()
  for t in 0 0.25 0.5 0.75 1; do
    "$MORPH" bear.off homer.off $t morphed.off
    render morphed.off "m_$t.png" 300 --up=+Y --camera-azimuth-angle=30 --camera-elevation-angle=10 --color=0.8,0.85,0.9
    panels+=("$(panel "m_$t.png" "t = $t" 300)")
  done
  row morph.png "${panels[@]}"
  finish morph.png morph.png
}

figure_search() {
  mkdir shapes
  cp armadillo.off bear.off bear_bis.off bull.off bunny00.off cactus.off camel.off cow.off dino.off diplodocus.off \
    hand.off homer.off man.off triceratops.off shapes/
  tool signature shapes -o index.db
  local rows=()
  for query in cow bear_bis; do
    tool search $query.off --index index.db -k 5 | sed 1d >found.txt
    local panels=()
    while read -r distance name; do
      mesh=$(basename "$name" .off)
      tool map "$name" -o sphere.off --stretch-ply shape.ply >/dev/null # f3d does not read every OFF file
      look_at "$mesh"
      render shape.ply "f_$mesh.png" 250 "${camera[@]}" --color=0.8,0.85,0.9
      panels+=("$(panel "f_$mesh.png" "$distance" 270)")
    done <found.txt
    row "row_$query.png" "${panels[@]}"
    rows+=("row_$query.png")
  done
  convert "${rows[@]}" -append search.png
  finish search.png search.png
}

figure_harmonics() {
  look_at armadillo
  tool map armadillo.off -o sphere.off --method isometric >/dev/null
  local panels=()
  for degree in 4 8 16 32 64 96; do
    tool harmonics armadillo.off --sphere sphere.off -o a.csv --degree $degree --fit integrals \
      --reconstruct smooth.ply >/dev/null
    render smooth.ply "h_$degree.png" 250 "${camera[@]}" --color=0.8,0.85,0.9
    panels+=("$(panel "h_$degree.png" "degree $degree" 270)")
  done
  row harmonics.png "${panels[@]}"
  finish harmonics.png harmonics.png
  local name
  for mesh in armadillo.off bunny00.off ${HARMONICS_MODELS:-bear.off}; do
    name=$(basename "$mesh" | sed -E 's/[0-9]*(_.*)?\..*//')
    for choice in isometric balanced; do
      tool harmonics "$mesh" -o a.csv --method $choice --fit integrals --degree 128 --report report.json >/dev/null
      printf '"%s, %s"\n' "$name" "$(sed s/balanced/conformal/ <<<$choice)"
      # the size is the root mean square over its ratio to the size
      awk -F'[:,]' '/"degree":/ { d = $2 } /"root_mean_square":/ { e = $2 } /"relative":/ { r = $2 }
                    /"hausdorff":/ { print d, r, $2 * r / e }' report.json
      printf '\n\n'
    done
  done >errors.txt
  gnuplot -e "table='errors.txt'; svg='$images/harmonic_errors.svg'" "$root/doc/figures/harmonic_errors.gp"
}

figure_scaling() {
  gnuplot -e "csv='$root/benchmark_results/scaling.csv'; svg='$images/scaling.svg'" "$root/benchmark/plot_scaling.gp"
}

figure_page() {
  "$root/web/install_dependencies.sh"
  node "$root/web/build.mjs"
  node "$root/web/picture.mjs" armadillo.off page.png
  convert page.png -colors 255 -dither None -define png:compression-level=9 "PNG8:$images/page.png"
}

for figure in "$@"; do
  echo "== $figure"
  "figure_$figure"
done
