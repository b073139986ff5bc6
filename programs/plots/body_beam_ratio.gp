# Critical points of the coupled beam over the ratio of its stiffnesses.
# Given: least, most (of the ratio); $first, $secondary, $folds, $cusps, $double; cusps: 1 where there is one.
set tics out nomirror
set border 31 lw 0.8
set xlabel 'angular momentum |{/:Bold a}| / {/:Italic l}({/:Italic ρμ}_1)^{1/2}'
set ylabel 'ratio of the bending stiffnesses {/:Italic μ}_2 / {/:Italic μ}_1'
set key outside right center samplen 2.6 spacing 1.3
plot [2.8:7.2][least:most] $first with lines lw 2.4 lc rgb '#0072b2' title 'the spin begins to whirl', \
    $secondary with lines lw 2 dt (8,4) lc rgb '#009e73' title 'secondary pitchforks', \
    $folds with lines lw 2 lc rgb '#d55e00' title 'folds', \
    $double with points pt 7 ps 1.3 lc rgb '#0072b2' title 'double pitchfork', \
    $cusps with points pt 9 ps 1.5 lc rgb 'black' title (cusps ? 'cusps' : '')
