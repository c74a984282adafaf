# Draws the first segment of a row that `texmap trace --stage 4 --csv FILE` wrote: the exact u of each
# pixel as a curve, stage 4's as its chord, and the error between them where it is largest. SVG.
BEGIN {
    FS = ","
    left = 60; bottom = 250; width = 640; height = 220
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"760\" height=\"296\"" \
        " viewBox=\"0 0 760 296\" role=\"img\" aria-labelledby=\"title\">"
    print "<title id=\"title\">u along one segment: the exact curve, and stage 4's chord</title>"
    print "<style>text{font:14px system-ui,sans-serif;fill:#1f2328}.axis{stroke:#8c959f}" \
        ".exact{stroke:#0067a5;fill:none;stroke-width:2}.chord{stroke:#b94a00;fill:none;" \
        "stroke-width:2;stroke-dasharray:7 4}.gap{stroke:#a3407c;stroke-width:2}" \
        "@media(prefers-color-scheme:dark){text{fill:#e6edf3}.exact{stroke:#56b4e9}" \
        ".chord{stroke:#e69f00}.gap{stroke:#d9a0c8}}</style>"
}
/^#/ { next }
!columns { columns = NF; for (i = 1; i <= NF; i++) at[$i] = i; next }
$1 == "segment" { segments++ }
$1 == "pixel" && segments <= 2 && $at["x"] <= 16 {
    n = $at["x"]; u[n] = $at["u"]; exact[n] = $at["exact_u"]
}
function x_of(pixel) { return left + pixel / 16 * width }
function y_of(value) { return bottom - value / u[16] * height }
function text(x, y, words, anchor) {
    printf "<text x=\"%d\" y=\"%d\" text-anchor=\"%s\">%s</text>\n", x, y, anchor, words
}
END {
    printf "<path class=\"axis\" d=\"M%d %dV%dH%d\" fill=\"none\"/>\n", left, bottom - height,
        bottom, left + width
    for (i = 0; i <= 16; i++) {
        curve = curve sprintf("%s%.1f %.1f", i ? "L" : "M", x_of(i), y_of(exact[i]))
        if (u[i] - exact[i] > u[most] - exact[most]) most = i
        if (i % 4 == 0) text(x_of(i), bottom + 20, i, "middle")
    }
    printf "<path class=\"exact\" d=\"%s\"/>\n", curve
    printf "<path class=\"chord\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", x_of(0), y_of(u[0]), x_of(16),
        y_of(u[16])
    printf "<path class=\"gap\" d=\"M%.1f %.1fV%.1f\"/>\n", x_of(most), y_of(u[most]),
        y_of(exact[most])
    text(x_of(most) + 8, y_of(exact[most]) + 24, \
        sprintf("pixel %d: %.2f texels", most, u[most] - exact[most]), "start")
    text(x_of(7), y_of(u[7]) - 12, "chord (stage 4)", "end")
    text(x_of(14) + 12, y_of(exact[13]) + 20, "exact u", "start")
    text(left - 8, bottom - height + 5, sprintf("%.0f", u[16]), "end")
    text(left - 8, bottom, 0, "end")
    text(left + width, bottom + 38, "pixel of the segment", "end")
    text(left - 45, bottom - height / 2, "u", "start")
    print "</svg>"
}
