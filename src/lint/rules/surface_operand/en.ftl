W313 = the { $operand } { $operand-id } { $what ->
    [whole] is a surface with no inside:
   *[part] has a surface with no inside in it:
} the intersection { $id } keeps only the part of that surface inside the { $other } { $other-id }
    .label = this operand
    .surface = the { $shape } { $shape-id } is a surface: it has no inside
    .help = operations need solids: use a half-space (type 4) instead of a plane (type 3), or a thin box instead of a rectangle
W313-outside = the { $operand } { $operand-id } { $what ->
    [whole] is a surface with no inside:
   *[part] has a surface with no inside in it:
} the difference { $id } keeps only the part of that surface outside the { $other } { $other-id }
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-tool = the { $operand } { $operand-id } { $what ->
    [whole] is a surface: taking it away
   *[part] has a surface in it: taking that away
} from the { $other } { $other-id } changes nothing
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-both = the { $operand } { $operand-id } and the { $other } { $other-id } are surfaces: their intersection { $id } is empty
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-complement = the { $operand } { $operand-id } { $what ->
    [whole] is a surface: its complement { $id } is all of space
   *[part] has a surface in it: the complement { $id } ignores that
}
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
