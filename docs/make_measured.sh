#!/usr/bin/env bash
# Draws docs/measured/*.svg: radiance of measured cloths and of ours; 32,768 rays per direction for the traced threads
# (SPP=32). Usage: docs/make_measured.sh [weftlight]; KEEP=FOLDER keeps the tables.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
weftlight=${1:-$root/build/release/weftlight}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$root/docs/measured"

# Six panels: two planes by three views; the y axis is logarithmic over three decades. Columns of the joined table: plane, view,
# light, measured, cloth, reference. `free`: ours are scaled by one factor, since the measured values are relative.
svg() {  # name title free
  awk -F, -v title="$2" -v free="$3" '
  function y(v, o) { v = log(v < 1e-9 ? 1e-9 : v) / log(10); if (v < low) v = low; if (v > low + 3) v = low + 3
                     return o + 150 - 140 * (v - low) / 3 }
  function x(d, o) { return o + 25 + (d + 80) * 1.35 }
  function curve(which, color, dash, s,    p, i) {
    for (p = 0; p < 6; ++p) {
      printf "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.6\"%s points=\"", color, dash
      for (i = p * 33 + 1; i <= p * 33 + 33; ++i) printf "%.1f,%.1f ", x(light[i], 260 * (p % 3)), y(v[which, i] * s, 40 + 190 * int(p / 3))
      print "\"/>"
    }
  }
  { plane[NR] = $1; view[NR] = $2; light[NR] = $3; for (k = 1; k <= 3; ++k) v[k, NR] = $(3 + k)
    if ($4 > peak) peak = $4 }
  END {
    s2 = s3 = 1
    if (free) {
      for (i = 1; i <= NR; ++i) if (v[1, i] > 0.03 * peak) { ++n; a += log(v[1, i] / v[2, i]); b += log(v[1, i] / v[3, i]) }
      s2 = exp(a / n); s3 = exp(b / n)
    }
    low = int(log(peak) / log(10) + 10) - 10 + 1 - 3
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-20 0 800 400\" width=\"800\" height=\"400\" font-family=\"sans-serif\" font-size=\"11\">"
    print "<rect x=\"-20\" width=\"800\" height=\"400\" fill=\"white\"/><text x=\"25\" y=\"18\" font-size=\"14\">" title "</text>"
    print "<text x=\"450\" y=\"18\" fill=\"#111\">measured</text><text x=\"530\" y=\"18\" fill=\"#d55e00\">cloth</text><text x=\"590\" y=\"18\" fill=\"#0072b2\">reference</text>"
    for (p = 0; p < 6; ++p) {
      ox = 260 * (p % 3); oy = 40 + 190 * int(p / 3); i = p * 33 + 1
      printf "<text x=\"%d\" y=\"%d\">%s plane, seen at %s\302\260</text>\n", ox + 30, oy + 2, plane[i], view[i]
      for (d = 0; d <= 3; ++d) printf "<line x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\" fill=\"#777\">%g</text>\n", ox + 25, ox + 241, oy + 150 - 140 * d / 3, oy + 150 - 140 * d / 3, ox + 23, oy + 153 - 140 * d / 3, 10 ^ (low + d)
      for (d = -80; d <= 80; d += 40) printf "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\" fill=\"#777\">%d\302\260</text>\n", x(d, ox), oy + 164, d
    }
    curve(1, "#111", " stroke-dasharray=\"4 3\"", 1); curve(2, "#d55e00", "", s2); curve(3, "#0072b2", "", s3)
    print "</svg>"
  }' "$work/table" > "$root/docs/measured/$1.svg"
}

cloth() {  # table name title column of the table, of ours
  local table=$root/tests/measured/$1 name=$2
  for method in cloth reference; do
    "$weftlight" response "$root/presets/cloths/$name.wif" -o "$work/$method.csv" --method $method --spp "${SPP:-32}"
  done
  paste -d, <(grep "^$name," "$table" | cut -d, -f2-4,"$4") <(tail -n +2 "$work/cloth.csv" | cut -d, -f5) \
    <(tail -n +2 "$work/reference.csv" | cut -d, -f5) > "$work/table"
  svg "$name" "$3" "$5"
  [[ -z ${KEEP:-} ]] || cp "$work/table" "$KEEP/$name.csv"  # measured, cloth, reference of one channel
}

cloth sadeghi2013.csv linen_plain "Linen, plain weave (green)" 6 0
cloth sadeghi2013.csv silk_crepe_de_chine "Silk crepe de chine (green)" 6 0
cloth sadeghi2013.csv polyester_satin_charmeuse "Polyester satin charmeuse (green)" 6 0
cloth denim2012.csv cotton_denim "Cotton denim (green)" 6 0
cloth irawan2012.csv silk_charmeuse "Silk charmeuse, shape" 5 1
cloth irawan2012.csv cotton_twill "Cotton twill, shape" 5 1
