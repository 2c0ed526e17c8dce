W315 = this comment hides { $count ->
    [one] a record, the { $type } { $id }
   *[other] { $count } records, from the { $type } { $id } on
}
    .label = the comment begins here
    .first = this would be a record
    .end = the comment ends here
    .help = close the comment with `#` on its own line; what is not wanted any more is better removed
    .fix = put each of the two lines into a comment of its own
