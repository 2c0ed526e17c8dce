W321 = in the { $operation } { $id }, { W321.the-tool } ends flush with { W321.the-other }: they share a face around ({ $x }, { $y }, { $z })
    .label = { $tool-face ->
        [side] the face at { $tool-name }
        [boundary] its boundary
        [base] its base
        [mantle] its side
        [disc] the disc that closes this end
        [piece] this piece
       *[all] its surface
    }
    .other = { $other-face ->
        [side] the face at { $other-name }
        [boundary] its boundary
        [base] its base
        [mantle] its side
        [disc] the disc that closes this end
        [piece] this piece
       *[all] its surface
    }
    .operation = the { $operation }
    .note = rounding decides whether a skin of no thickness is left there
    .help = let the tool reach a little past the face that it cuts through
    .fix = let it reach slightly further
    .the-tool = { $tool-copy ->
        [none] the { $tool } { $tool-id }{ $tool-in ->
            [none] {""}
           *[other] {" "}in { $tool-in }
        }
       *[other] the { $tool } { $tool-id } in the copy { $tool-copy }
    }
    .the-other = { $other-copy ->
        [none] the { $other } { $other-id }{ $other-in ->
            [none] {""}
           *[other] {" "}in { $other-in }
        }
       *[other] the { $other } { $other-id } in the copy { $other-copy }
    }
W321-round = { W321 }
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = { W321.note }
    .help = make the tool a little larger there than what it cuts, or write both alike: equal shapes in one place are decided exactly
    .fix = { W321.fix }
W321-holes = in the { $operation } { $id }, { W321.the-tool } cuts up to where { W321.the-other } does: they share a face around ({ $x }, { $y }, { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = rounding decides whether a wall of no thickness is left between the two
    .help = let one of the two reach a little into the other
    .fix = { W321.fix }
W321-touch = in the { $operation } { $id }, { W321.the-tool } and { W321.the-other } only touch: they share a face around ({ $x }, { $y }, { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = what they have in common there is a sheet of no thickness; rounding decides whether it is seen
W321-empty = { W321-touch }
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = { W321-touch.note }
    .help = the intersection is otherwise empty: did you mean a union?
    .fix-union = for a union, write { $number }
