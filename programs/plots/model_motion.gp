# A motion of a model over time: a panel for each unknown, and one for the energies.
# Given: heading, time_label, until; unknowns, array labels; $motion: the time, each unknown, kinetic energy, potential energy,
#   their sum.
panels = unknowns + 1
columns = panels < 3 ? panels : 3
rows = (panels + columns - 1) / columns
set multiplot layout rows,columns title heading margins screen 0.02 + 0.14 / columns, 0.98, 0.02 + 0.18 / rows, 1 - 0.2 / rows \
    spacing screen 0.16 / columns + 0.03, 0.3 / rows
set tics out nomirror
set border 31 lw 0.8
set grid lc rgb '#dddddd'
set xlabel time_label
unset key
do for [u=1:unknowns] {
    set label 1 labels[u] at graph 0, graph 1.09 left
    plot [0:until] $motion using 1:u+1 with lines lw 2 lc rgb '#0072b2'
}
set label 1 'energy' at graph 0, graph 1.09 left
set key at graph 1.02, graph 1.09 right center horizontal maxrows 1 samplen 1 width -2 font ',11'
plot [0:until] $motion using 1:unknowns+2 with lines lw 2 lc rgb '#d55e00' title 'kinetic', \
    $motion using 1:unknowns+3 with lines lw 2 lc rgb '#009e73' title 'potential', \
    $motion using 1:unknowns+4 with lines lw 2 lc rgb 'black' title 'sum'
unset multiplot
