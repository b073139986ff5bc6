# Shapes of the beam in the plane in which it is bent: a row for each strain energy.
# Given: columns, of a row; shapes, and for each of them, by rows: $shape1, $shape2, .. and the arrays row (from 0),
#   column (from 0), caption, axis (the plane: 1 or 2), across (1: the axis of rotation is normal to the plane),
#   centre_x, centre_y (of mass), along_x, along_y (the axis); heading, of each row.
set multiplot layout 2,columns margins 0.012,0.988,0.02,0.89 spacing 0.012,0.15
unset key
unset tics
set border 31 lw 0.4 lc rgb '#bbbbbb'
set size ratio -1
k = 1
do for [place=0:2*columns-1] {
    if (k > shapes || row[k] * columns + column[k] != place) {
        set multiplot next
    } else {
        unset arrow
        unset object
        unset label
        if (column[k] == 0) {
            set label 9 heading[row[k]+1] at screen 0.012,(row[k] == 0 ? 0.965 : 0.465) left
        }
        set object 1 ellipse center 0,-0.17 size 0.62,0.34 fs solid 1 fc rgb '#9ecae1' lw 1
        set arrow 1 from -1,-1.1 to -0.6,-1.1 lw 0.8 lc rgb '#777777' size 0.07,20 filled
        set arrow 2 from -1,-1.1 to -1,-0.7 lw 0.8 lc rgb '#777777' size 0.07,20 filled
        set label 1 '3' at -1,-0.58 center tc rgb '#777777'
        set label 2 sprintf('%d', axis[k]) at -0.54,-1.1 tc rgb '#777777'
        if (across[k]) {
            set object 3 circle center centre_x[k],centre_y[k] size 0.11 front fs empty border lc rgb '#d55e00' lw 2
            set object 4 circle center centre_x[k],centre_y[k] size 0.035 front fs solid fc rgb '#d55e00' lw 0
        } else {
            set arrow 3 from centre_x[k]-along_x[k],centre_y[k]-along_y[k] \
                to centre_x[k]+1.15*along_x[k],centre_y[k]+1.15*along_y[k] \
                front lw 1.6 dt (12,4,2,4) lc rgb '#d55e00' size 0.1,18 filled
            set object 4 circle center centre_x[k],centre_y[k] size 0.04 front fs solid fc rgb '#d55e00' lw 0
        }
        set title caption[k] offset 0,-0.7
        eval(sprintf("plot [-1.15:1.95][-1.25:1.55] $shape%d with lines lw 4 lc rgb 'black'", k))
        k = k + 1
    }
}
unset multiplot
