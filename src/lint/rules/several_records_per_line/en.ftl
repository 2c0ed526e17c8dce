S503 = { $count ->
    [one] a second record on the same line
   *[other] { $count } more records on the same line
}
    .fix = put each record on a line of its own
    .fix-zero = take the `0` away: alone it is an empty record
