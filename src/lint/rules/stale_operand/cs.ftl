W309 = { $change } objektu { $id } přichází pozdě: { $taker } { $taker-id } už má jeho dřívější podobu{ $more ->
    [0] {""}
    [one] ; totéž platí o další { $more } změně
    [few] ; totéž platí o dalších { $more } změnách
   *[other] ; totéž platí o dalších { $more } změnách
}
    .label = na výsledku se to už neprojeví
    .taken = zde se { $id } použije
    .note = operace bere operandy v té podobě, jakou v daném místě mají
    .help = přesuňte tento záznam před ten, který { $id } používá, nebo změňte { $taker-id } místo { $id }
W309-property = { $type } { $id } se mění pozdě: { $taker-id } už má dřívější podobu{ $more ->
    [0] {""}
    [one] ; totéž platí o další { $more } změně
    [few] ; totéž platí o dalších { $more } změnách
   *[other] ; totéž platí o dalších { $more } změnách
}
    .label = { W309.label }
    .taken = { W309.taken }
    .note = vlastnosti a barvy se přiřazují v té podobě, jakou v daném místě mají
    .help = přesuňte tento záznam před ten, který { $id } používá
