W309 = { $change } objektu { $id } přichází pozdě: { $taker } { $taker-id } už používá jeho dřívější podobu{ $more ->
    [0] {""}
    [one] ; totéž platí o { $more } další změně
    [few] ; totéž platí o { $more } dalších změnách
   *[other] ; totéž platí o { $more } dalších změnách
}
    .label = na výsledku se to už neprojeví
    .taken = zde se { $id } použije
    .note = operace použije operandy v té podobě, jakou v jejím místě mají
    .help = přesuňte tento záznam před ten, který { $id } používá, nebo změňte { $taker-id } místo { $id }
    .fix = patří-li objektu hned nad ním, napsat { $number }
W309-property = { $type } { $id } se mění pozdě: { $taker-id } už používá dřívější podobu{ $more ->
    [0] {""}
    [one] ; totéž platí o { $more } další změně
    [few] ; totéž platí o { $more } dalších změnách
   *[other] ; totéž platí o { $more } dalších změnách
}
    .label = { W309.label }
    .taken = { W309.taken }
    .note = vlastnosti a barvy se přiřazují v té podobě, jakou v místě přiřazení mají
    .help = přesuňte tento záznam před ten, který { $id } používá
    .fix = { W309.fix }
