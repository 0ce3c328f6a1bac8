# SPDX-License-Identifier: BSL-1.0
#
# From the output of g++ or clang++ the first error, for somebody who has written one short file: three lines, the line in
# that file (0 if it is elsewhere), where the error was raised, and what it says.
#
#   awk -v file=<exercise.hpp> -v root=<the project's folder>/ -f first_error.awk <log>

function place(text) { return match(text, /exercise\.hpp:[0-9]+/) ? substr(text, RSTART + 13, RLENGTH - 13) + 0 : 0 }

# The compiler's "unit<list<dim<length_base_dimension, static_rational<1> >, ..." as m, kg, s with their powers.
function unit_of(text,    over, under, name, power) {
    sub(/homogeneous_system.*/, "", text)
    while (match(text, /dim<[a-z:_]*_base_dimension, *(boost::units::)?static_rational<-?[0-9]+/)) {
        name = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        power = name; sub(/.*</, "", power); power += 0
        name = name ~ /length/ ? "m" : name ~ /mass/ ? "kg" : name ~ /time/ ? "s" : name ~ /plane_angle/ ? "rad" : "?"
        if (power > 0 && name == "kg") over = name (power == 1 ? "" : "^" power) (over == "" ? "" : " ") over
        else if (power > 0) over = over (over == "" ? "" : " ") name (power == 1 ? "" : "^" power)
        else under = under (under == "" ? "" : " ") name (power == -1 ? "" : "^" (-power))
    }
    return (over == "" ? (under == "" ? "no unit" : "1") : over) (under == "" ? "" : "/" under)
}

# Where the bracket ends that is open at the beginning of the text.
function end_of(text,    i, c, depth) {
    depth = 1
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        if (c == "<") depth++
        else if (c == ">" && --depth == 0) return i
    }
    return length(text)
}

# Each quantity's type by its unit: "quantity in m/s", "vector in m".
function readable(text,    before, inside, n, shown) {
    gsub(/boost::units::/, "", text)
    while (match(text, /(const )?quantity<unit</)) {
        before = substr(text, 1, RSTART - 1)
        text = substr(text, RSTART + RLENGTH)
        n = end_of(text)                       # of the unit
        inside = substr(text, 1, n)
        text = substr(text, n + 1)
        n = end_of(text)                       # of the quantity
        shown = (substr(text, 1, n) ~ /Matrix/ ? "vector in " : "quantity in ") unit_of(inside)
        text = before shown substr(text, n + 1)
    }
    return text
}

# What the library says with the name of a deleted function: the name as a sentence, and the two units.
function sentence(text,    words, first, second) {
    if (!match(text, /Ansatz_units_[a-z_]+/)) return text
    words = substr(text, RSTART + 13, RLENGTH - 13)
    gsub(/_/, " ", words)
    if (match(text, /Unit1 = /)) first = unit_of(substr(text, RSTART + 8))
    if (match(text, /Unit2 = /)) second = unit_of(substr(text, RSTART + 8))
    return words (first != "" && second != "" ? ": " first " and " second : "")
}

# A type as a person calls it: 'Length' {aka 'quantity in m'} is a quantity in m.
function called(text) {
    if (match(text, /\(aka '|\{aka '/)) text = substr(text, RSTART + RLENGTH)
    sub(/^'/, "", text)
    sub(/'.*/, "", text)
    if (text ~ /^(const )?(double|float|int|long|unsigned|unsigned long|std::size_t|size_t)( const)?&?$/) return "a plain number"
    return (text ~ /^(quantity|vector) in / ? "a " : "") text
}
# A quantity where one of another unit belongs, most often behind `return`: what it is and what belongs there, and nothing
# of how either came to be.
function conversion(text,    told, from, to, at) {
    told = text
    gsub(/\342\200\230|\342\200\231/, "'", told)
    if (told !~ /could not convert '|cannot convert '|no viable conversion from |conversion from '/) return text
    if (told ~ /cannot convert '/) sub(/^.*cannot convert /, "", told)
    else while (match(told, /(^|[ )])from (returned value of type )?'/)) told = substr(told, RSTART + RLENGTH - 1)
    at = match(told, / to (function return type |non-scalar type )?'/)
    if (!at) return text
    from = substr(told, 1, at - 1)
    to = substr(told, at); sub(/^ to (function return type |non-scalar type )?/, "", to)
    if (from to !~ /(quantity|vector) in /) return text
    return "this is " called(from) ", where " called(to) " belongs"
}

# What a compiler says in its own words, where a person needs others.
function plain(text) {
    if (text ~ /no return statement in function|control reaches end of non-void|non-void function.* does not return a value/)
        return "the function ends without return"
    sub(/ *\[-Werror[^]]*\]$/, "", text)
    return text
}

# What the linker misses, or has twice: the name between its quotes, with clang's or without.
function symbol_of(text) {
    sub(/^.*(undefined reference to|multiple definition of|undefined symbol:|duplicate symbol:) */, "", text)
    sub(/^[`'"\342\200\230]+/, "", text)
    sub(/['"\342\200\231]+;.*$/, "", text)
    sub(/['"\342\200\231]+$/, "", text)
    return text
}
function linker_message(text,    name, doubled) {
    doubled = text ~ /multiple definition|duplicate symbol/
    name = symbol_of(text)
    if (doubled && name ~ /^main(\(.*)?$/) return "there are two of main: the tests have their own, so that an answer has none"
    if (doubled) return "there are two of " name ": write it once, and 'inline' before a function of a header"
    return name " is declared and used, but it is defined nowhere"
}
function found_at(place_in_file, where_it_is, text) {
    found = 1
    line = place_in_file
    where = where_it_is
    message = text
}

/No space left on device/ && !found { found_at(0, "disk", "no space is left on the disk: make room and give the same command again") }
/(undefined reference to|multiple definition of|undefined symbol:|duplicate symbol:)/ && !found { found_at(0, "linking", linker_message($0)) }
# The lines of subject.hpp after the answer ask whether a bracket is open there. Then the compiler has often missed another
# one before, in a place that is right.
/subject\.hpp:[0-9]+.*error:/ && (!found || message ~ /expected .*[;}]|function.definition is not allowed/) {
    found_at(0, "end", "something is open at the end of the file: most often a closing brace } is missing")
    next
}
/In file included from/ { near = 0 }
!/error:/ && place($0) && /required|instantiation/ { near = place($0) }
/error:/ && !found {
    message = $0
    sub(/^.*error: /, "", message)
    if (sub(/^static assertion failed( due to requirement .*)?: /, "", message) || sub(/^static_assert failed( due to requirement .*)? "/, "", message))
        sub(/"$/, "", message)
    deleted = message ~ /deleted operator/
    found_at(index($0, file) ? place($0) : near, $0, plain(conversion(readable(sentence(message)))))
    sub(/: (fatal )?error: .*/, "", where)
    if (index(where, root) == 1) where = substr(where, length(root) + 1)
    next
}
# clang++ names the deleted operator first, and the sentence that is its type only afterwards.
found && deleted && /Ansatz_units_/ { message = sentence($0); deleted = 0 }
# clang++ says afterwards from where it came.
found && !line && /note: (in instantiation|while)|required from/ && place($0) { line = place($0) }
END {
    if (!found) exit 1
    print line + 0
    print where
    print message
}
