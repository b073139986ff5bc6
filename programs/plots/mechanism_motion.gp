# A motion of the mechanism over time.
# Given: what (with its unit), names (q1 q2 ..), colours, first (the column of the first of them); $motion.
set tics out nomirror
set border 31 lw 0.8
set xlabel '{/:Italic t} [s]'
set grid lc rgb '#dddddd'
set ylabel what
set key outside right center
italic(name) = '{/:Italic '.name[1:1].'}_'.name[2:]
plot [0:10] for [k=1:words(names)] $motion using 1:first+k-1 with lines lw 2 lc rgb word(colours, k) \
    title italic(word(names, k))
