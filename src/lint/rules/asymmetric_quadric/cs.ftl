W304 = matice kvadriky { $id } není symetrická: { $first } je `{ $first-number }`, ale { $mirror } je `{ $mirror-number }`{ $more ->
    [0] {""}
    [one] {" "}a liší se ještě { $more } dvojice
    [few] {" "}a liší se ještě { $more } dvojice
   *[other] {" "}a liší se ještě { $more } dvojic
}
    .label = { $first }
    .other = { $mirror }
    .note = záleží jen na součtu obou čísel: kvadrika se vykreslí, jako by na obou místech byl jejich průměr
    .fix = { $pairs ->
        [one] napsat na obě místa jejich průměr
        [few] napsat průměr ve všech { $pairs } dvojicích
       *[other] napsat průměr ve všech { $pairs } dvojicích
    }
