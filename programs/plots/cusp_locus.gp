# The cusps of the two-link chain over the ratio: a panel for alpha, one for omega. In their scales, the fourth root of
# alpha and the cube root of omega - 1, the curve runs straight into its end at ratio 1.
# Given: low, high (of the ratio), arrays panel_left, panel_right (of each panel, in its scale) and ticks (what `set xtics` takes);
#   not_shown: ratios of planes beyond the panels, or nothing; transitions and arrays for them, for one panel and then for
#   the other: label_kind, label_place, label_x, label_y; at_window, at_degenerate, at_other, any: 1 where there is such a thing;
#   $curves, $planes, $cusps, $window, $degenerate, $other, $transitions: alpha, omega in their scales, ratio.
set multiplot
set tics out nomirror
set border 31 lw 0.8
set bmargin at screen 0.22
set tmargin at screen 0.9
unset key
set clip two
set label 'Cusps of the rotating two-link chain' at screen 0.5,0.965 center font ',16'
if (strlen(not_shown) > 0) {
    set label 'no cusps in planes at {/:Italic r} = '.not_shown at screen 0.97,0.925 right font ',11' tc rgb 'gray40'
}
do for [panel=1:2] {
    eval('set xtics '.ticks[panel])
    do for [k=1:transitions] {
        n = (panel - 1) * transitions + k
        caption = label_kind[n]."\n".label_place[n]
        place = (label_x[n] - panel_left[panel]) / (panel_right[panel] - panel_left[panel])
        if (place < 0.3) {
            set label caption at label_x[n],label_y[n] left offset -3,2.2
        } else {
            if (place > 0.7) {
                set label caption at label_x[n],label_y[n] right offset 3,2.2
            } else {
                set label caption at label_x[n],label_y[n] center offset 0,2.2
            }
        }
    }
    if (panel == 1) {
        set xlabel '{/:Italic α} = {/:Italic m}_2 / ({/:Italic m}_1 + {/:Italic m}_2),  scale of {/:Italic α}^{ 1/4}'
        set ylabel '{/:Italic r} = {/:Italic l}_2 / {/:Italic l}_1'
        set lmargin at screen 0.09
        set rmargin at screen 0.53
    } else {
        set xlabel '{/:Italic ω},  scale of ({/:Italic ω} − 1)^{1/3}'
        unset ylabel
        set lmargin at screen 0.58
        set rmargin at screen 0.97
    }
    plot [panel_left[panel]:panel_right[panel]][low:high] \
        $planes using panel:3 with lines dt 2 lw 0.8 lc rgb 'gray60', \
        $curves using panel:3 with lines lw 2.6 lc rgb '#0072b2', \
        $cusps using panel:3 with points pt 6 ps 0.9 lw 1.4 lc rgb 'black', \
        for [k=1:at_window] $window using panel:3 with points pt 5 ps 0.9 lc rgb '#0072b2', \
        for [k=1:at_degenerate] $degenerate using panel:3 with points pt 13 ps 1.3 lc rgb '#009e73', \
        for [k=1:at_other] $other using panel:3 with points pt 9 ps 1.2 lc rgb 'black', \
        for [k=1:any] $transitions using panel:3 with points pt 7 ps 1 lc rgb '#d55e00'
    unset label
}
# the key in a frame of its own: in a panel it would be no wider than that
set lmargin at screen 0.02
set rmargin at screen 0.98
set bmargin at screen 0
set tmargin at screen 0.1
unset border
unset tics
unset xlabel
set key center center horizontal Left reverse samplen 2
# an iteration without entries would leave an empty place in it
entries = "NaN with lines dt 2 lw 0.8 lc rgb 'gray60' title 'plane solved for all cusps'" \
    .", NaN with lines lw 2.6 lc rgb '#0072b2' title 'cusps'" \
    .", NaN with points pt 6 ps 0.9 lw 1.4 lc rgb 'black' title 'solution in a plane'"
if (at_window) { entries = entries.", NaN with points pt 5 ps 0.9 lc rgb '#0072b2' title 'end: window'" }
if (at_degenerate) { entries = entries.", NaN with points pt 13 ps 1.3 lc rgb '#009e73' title 'end: model degenerate'" }
if (at_other) { entries = entries.", NaN with points pt 9 ps 1.2 lc rgb 'black' title 'other end'" }
if (any) { entries = entries.", NaN with points pt 7 ps 1 lc rgb '#d55e00' title 'transition'" }
eval('plot [0:1][0:1] '.entries)
unset multiplot
