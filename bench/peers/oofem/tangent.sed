# For OOFEM's src/sm/Elements/Beams/libeam3dnl.C: sed -E -i -f tangent.sed libeam3dnl.C. The rotation in the middle of an
# element is half the sum of those of its nodes, but the geometric part of the tangent takes the whole sum: it is twice that
# of the element's own forces. Equilibria are the same, Newton's method gets there.
/^ +\/\/ ks1/,/computeGaussPoints/ {
    s/(\+=|-=) (sn|sm)\.at/\1 0.5 * \2.at/
    s/y\.times\(0\.5\)/y.times(0.25)/
}
