# A damped motion that settles, for both strain energies, in three panels.
# Given: end (of the time); $linear, $coupled: time, wobble, tip displacement, energy.
set tics out nomirror
set border 31 lw 0.8
set multiplot layout 3,1 margins 0.1,0.98,0.1,0.93 spacing 0.025
set grid lc rgb '#dddddd'
set format x ''
set key at screen 0.54,0.985 center top horizontal samplen 3
array labels[3] = ['wobble angle [°]', 'tip displacement / {/:Italic l}', 'energy / ({/:Italic μ}_1/{/:Italic l})']
do for [k=1:3] {
    if (k == 3) {
        set format x '%g'
        set xlabel 'time {/:Italic t} / {/:Italic l}^2({/:Italic ρ}/{/:Italic μ}_1)^{1/2}'
    }
    set ylabel labels[k]
    plot [0:end] $linear using 1:k+1 with lines lw 1.6 lc rgb '#0072b2' title 'linear strain', \
        $coupled using 1:k+1 with lines lw 1.6 lc rgb '#d55e00' title 'coupled strain'
    unset key
}
unset multiplot
