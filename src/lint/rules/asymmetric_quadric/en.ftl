W304 = the matrix of the quadric { $id } is not symmetric: { $first } is { $first-number } but { $mirror } is { $mirror-number }{ $more ->
    [0] {""}
    [one] , and { $more } more pair differs
   *[other] , and { $more } more pairs differ
}
    .label = { $first }
    .other = { $mirror }
    .note = only the sum of the two counts: the quadric is drawn as if both were their mean
    .fix = { $pairs ->
        [one] write their mean in both places
       *[other] write the mean of both in all { $pairs } pairs
    }
