W315 = this comment hides { $count ->
    [one] a record, the { $type } { $id }
   *[other] { $count } records, from the { $type } { $id } on
}
    .label = the comment begins here
    .first = this would be a record
    .end = the comment ends here
    .help = close the comment with `#` on its own line, or remove the records if they are no longer wanted
    .fix = put each of the two lines into a comment of its own
