W312 = the box of the render record cuts the scene: the { $type } { $id } reaches out of it at ({ $x }, { $y }, { $z })
    .label = what lies outside of this box is invisible
    .shape = this reaches out of it
    .note = the cut leaves an opening: the inside of the object is visible
    .help = make the box larger, or say that the cut is meant: `# zpg: allow(W312) #`
W312-outside = nothing will be seen: all of the object { $id } lies outside of the box of the render record, its { $axis } is { $where ->
        [above] at least
       *[below] at most
    } { $reach } everywhere
    .label = { $name }, the side of the box
    .note = what lies outside of the box is invisible, for all rays
W312-part = nothing will be seen of the { $type } { $id }: all of it lies outside of the box of the render record, its { $axis } is { $where ->
        [above] at least
       *[below] at most
    } { $reach } everywhere{ $others ->
        [0] {""}
        [one] ; { $others } other part lies outside too
       *[other] ; { $others } other parts lie outside too
    }
    .label = { $name }, the side of the box
    .shape = this is not drawn
    .note = { W312-outside.note }
    .help = make the box larger, or take out what is not drawn
