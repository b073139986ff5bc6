# Doxygen's filter of the guides: gives each heading the name that it has on GitHub, which links lead to, with its page's
# before it, since names of headings are one list for all pages. A link to a file that is no page is left out, not its text.
function page_of(path) {
    sub(/.*\//, "", path)
    sub(/[.]md$/, "", path)
    return path
}
function anchor(heading) {
    heading = tolower(heading)
    gsub(/[^a-z0-9 _-]/, "", heading)
    gsub(/ /, "-", heading)
    return heading
}
BEGIN {
    link = "[]][(][^()]*[)]"
}
FNR == 1 {
    page = FILENAME ~ /docs\/README[.]md$/ ? "documentation" : page_of(FILENAME)
}
/^ *```/ {
    fenced = !fenced
}
fenced || /^    / {
    print
    next
}
/^# / && page == "documentation" {
    print $0 " {#documentation}"
    next
}
/^##+ / {
    heading = $0
    sub(/^#+ /, "", heading)
    print $0 " {#" page "-" anchor(heading) "}"
    next
}
{
    out = ""
    rest = $0
    while (match(rest, link)) {
        target = substr(rest, RSTART + 2, RLENGTH - 3)
        before = substr(rest, 1, RSTART - 1)
        rest = substr(rest, RSTART + RLENGTH)
        if (target ~ /^https?:/ || target ~ /[.]png$/) {
            out = out before "](" target ")"
        } else if (target ~ /README[.]md$/) {
            out = out before "](@ref documentation)"
        } else if (target ~ /^[^#]*[.]md$/) {
            out = out before "](" target ")"
        } else if (target ~ /#/) {
            file = target
            sub(/#.*/, "", file)
            sub(/[^#]*#/, "", target)
            out = out before "](@ref " (file == "" ? page : page_of(file)) "-" target ")"
        } else {
            sub(/.*/, "", target)
            text = before
            if (match(text, /[[][^[]*$/)) text = substr(text, 1, RSTART - 1) substr(text, RSTART + 1)
            out = out text
        }
    }
    print out rest
}
